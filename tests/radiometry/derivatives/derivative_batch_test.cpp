// SPDX-License-Identifier: GPL-3.0-or-later
// What may be left out or shared to save time does not change a bit: receivers
// in blocks, quantities that are not asked for, E on the way.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

using Bits = std::vector<std::uint64_t>;

void Append(const Vector3& v, Bits& bits) {
  for (const double x : {v.x, v.y, v.z})
    bits.push_back(std::bit_cast<std::uint64_t>(x));
}

/// What every choice of options has.
Bits GradientBits(const Derivatives& d) {
  Bits bits;
  for (std::size_t c = 0; c < 3; ++c) {
    bits.push_back(std::bit_cast<std::uint64_t>(d.irradiance.value[c]));
    bits.push_back(std::bit_cast<std::uint64_t>(d.irradiance.bound[c]));
    if (d.smoothness == Smoothness::kDiscontinuous) continue;
    for (const auto* all : {&d.channels, &d.bounds}) {
      Append((*all)[c].gradient, bits);
      Append((*all)[c].tangential, bits);
      Append((*all)[c].normal, bits);
      Append((*all)[c].vector, bits);
    }
  }
  return bits;
}

void AppendMatrix(const Matrix3& m, Bits& bits) {
  for (const auto& row : m)
    Append({row[0], row[1], row[2]}, bits);
}

Bits AllBits(const Derivatives& d) {
  Bits bits = GradientBits(d);
  for (std::size_t c = 0; c < 3; ++c) {
    if (d.smoothness == Smoothness::kDiscontinuous) continue;
    AppendMatrix(d.channels[c].jacobian, bits);
    AppendMatrix(d.channels[c].sphere_jacobian, bits);
    Append(d.channels[c].sphere, bits);
    bits.push_back(std::bit_cast<std::uint64_t>(d.channels[c].flux));
  }
  return bits;
}

/// Lamps above and below the receivers, which share a normal, as in a block of
/// which tree nodes below the horizon are left out.
class Batch : public ::testing::TestWithParam<Method> {
 protected:
  Batch() {
    PortableRandom random(77);
    std::vector<TestFace> faces = RandomScene(random, false, 10);
    faces.push_back({Floor(-3, 3, -3, 3, -2), {1, 2, 0.5}});
    faces.push_back({Ceiling(-3, 3, -3, 3, 4), {1, 2, 0.5}});
    faces.push_back({Ceiling(4, 5, -1, 1, 3), {2, 0, 0.5}});
    scene_ = MakeScene(faces);
    for (int i = 0; i < 70; ++i) {
      receivers_.push_back(
          {{0.02 * i - 0.7, 0.013 * i - 0.4, 0.1}, {0, 0, 1}, 0});
    }
  }

  [[nodiscard]] std::vector<Derivatives> Together(
      const Oracle& oracle, const DerivativeOptions& options) const {
    std::vector<Derivatives> all;
    oracle.Derivatives(
        receivers_, options,
        [&all](std::size_t, const Derivatives& d) { all.push_back(d); });
    return all;
  }

  Scene scene_;
  std::vector<Receiver> receivers_;
};

TEST_P(Batch, GivesTheBitsOfEveryReceiverAlone) {
  const Oracle oracle(scene_, {.method = GetParam()});
  const std::vector<Derivatives> together = Together(oracle, {});
  int below = 0;
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const Derivatives alone = oracle.Derivatives(receivers_[i]);
    EXPECT_EQ(AllBits(together[i]), AllBits(alone)) << i;
    // What only the sphere sees is there.
    if (alone.channels[1].flux < alone.irradiance.value[1]) ++below;
  }
  EXPECT_GT(below, 60);
}

TEST_P(Batch, WhatIsNotAskedForChangesNothing) {
  const Oracle oracle(scene_, {.method = GetParam()});
  const std::vector<Derivatives> all = Together(oracle, {});
  constexpr std::array<DerivativeOptions, 3> kLess = {
      {{.sphere = false, .jacobian = false},
       {.sphere = true, .jacobian = false},
       {.sphere = false, .jacobian = true}}};
  for (const DerivativeOptions& options : kLess) {
    const std::vector<Derivatives> some = Together(oracle, options);
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      if (GetParam() == Method::kCertified) {
        EXPECT_EQ(GradientBits(some[i]), GradientBits(all[i])) << i;
        continue;
      }
      // In double the gradient is summed in another order.
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(some[i].channels[c].gradient.x,
                    all[i].channels[c].gradient.x,
                    some[i].bounds[c].gradient.x + all[i].bounds[c].gradient.x);
      }
    }
  }
}

TEST_P(Batch, IrradianceHasTheBitsOfEvaluate) {
  // With sources of one emission, of several, and with one source alone.
  for (const bool is_single : {false, true}) {
    const Scene scene = is_single
                            ? MakeScene({{Ceiling(-1, 1, -1, 1, 2), kLamp},
                                         {Ceiling(0, 2, -0.5, 0.5, 1)}})
                            : scene_;
    for (const Emission emission : {Emission::kExitance, Emission::kRadiance}) {
      const Oracle oracle(scene, {.method = GetParam(), .emission = emission});
      for (const Receiver& receiver : receivers_) {
        const Irradiance e = oracle.Evaluate(receiver);
        const Derivatives d = oracle.Derivatives(receiver, {false, false});
        EXPECT_EQ(d.irradiance.value, e.value);
        EXPECT_EQ(d.irradiance.bound, e.bound);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Batch,
                         ::testing::Values(Method::kCertified,
                                           Method::kDouble));

}  // namespace
}  // namespace truelux
