// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by the receiver: identities, differences of the certified
// irradiance, one-sided differences at kinks, zeros by symmetry.

#include "truelux/derivatives.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

double Dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Receiver Moved(const Receiver& receiver, const Vector3& d, double step) {
  Receiver moved = receiver;
  moved.position.x += step * d.x;
  moved.position.y += step * d.y;
  moved.position.z += step * d.z;
  return moved;
}

double SizeOf(const Vector3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// E'(r; d) as gradient and kinks say.
double OneSided(const Derivatives& derivatives, std::size_t channel,
                const Vector3& d) {
  double slope = Dot(derivatives.channels[channel].gradient, d);
  for (const Kink& kink : derivatives.kinks)
    slope += kink.size[channel] * std::fabs(Dot(kink.normal, d));
  return slope;
}

class OnRandomScenes : public ::testing::TestWithParam<int> {
 protected:
  OnRandomScenes()
      : random_(static_cast<std::uint64_t>(GetParam()) + 900),
        scene_(MakeScene(RandomScene(random_, GetParam() % 2 == 0, 14))),
        receiver_(RandomReceiver(random_, GetParam() % 2 == 0)),
        oracle_(scene_),
        derivatives_(oracle_.Derivatives(receiver_)) {}

  PortableRandom random_;
  Scene scene_;
  Receiver receiver_;
  Oracle oracle_;
  Derivatives derivatives_;
};

TEST_P(OnRandomScenes, IrradianceHasTheBitsOfEvaluate) {
  const Irradiance irradiance = oracle_.Evaluate(receiver_);
  EXPECT_EQ(derivatives_.irradiance.value, irradiance.value);
  EXPECT_EQ(derivatives_.irradiance.bound, irradiance.bound);
}

// V . n = |n| E, div V = 0, and the gradient is J^T n / |n|.
TEST_P(OnRandomScenes, IdentitiesHold) {
  if (derivatives_.smoothness == Smoothness::kDiscontinuous) return;
  const Vector3& n = receiver_.normal;
  const double length = std::sqrt(Dot(n, n));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const ChannelDerivatives& d = derivatives_.channels[channel];
    const double e = derivatives_.irradiance.value[channel];
    EXPECT_NEAR(Dot(d.vector, n), length * e,
                1e-14 * length * SizeOf(d.vector));
    EXPECT_NEAR(Dot(d.normal, n), 0, 1e-14 * length * SizeOf(d.vector));
    EXPECT_NEAR(Dot(d.sphere, n), length * d.flux,
                1e-14 * length * SizeOf(d.sphere));
    for (const Matrix3* j : {&d.jacobian, &d.sphere_jacobian}) {
      double size = 0;
      for (const auto& row : *j) {
        for (const double x : row)
          size = std::max(size, std::fabs(x));
      }
      EXPECT_NEAR((*j)[0][0] + (*j)[1][1] + (*j)[2][2], 0, 1e-14 * size);
    }
    const auto gradient = [&](std::size_t k) {
      return (n.x * d.jacobian[0][k] + n.y * d.jacobian[1][k] +
              n.z * d.jacobian[2][k]) /
             length;
    };
    const double size = SizeOf(d.gradient);
    EXPECT_NEAR(d.gradient.x, gradient(0), 1e-13 * (size + 1e-3));
    EXPECT_NEAR(d.gradient.y, gradient(1), 1e-13 * (size + 1e-3));
    EXPECT_NEAR(d.gradient.z, gradient(2), 1e-13 * (size + 1e-3));
  }
}

// E(n) - E(-n) is the flux, and V by the normal is the slope of E.
TEST_P(OnRandomScenes, TheOtherSideAndTheNormal) {
  if (derivatives_.smoothness == Smoothness::kDiscontinuous) return;
  Receiver turned = receiver_;
  turned.normal = {-turned.normal.x, -turned.normal.y, -turned.normal.z};
  const Rgb other = oracle_.Evaluate(turned).value;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double e = derivatives_.irradiance.value[channel];
    EXPECT_NEAR(derivatives_.channels[channel].flux, e - other[channel],
                1e-15 * (e + other[channel]));
  }
}

// On a lattice many receivers are at kinks: differences go to one side.
TEST_P(OnRandomScenes, DifferencesOfIrradianceApproachThem) {
  if (derivatives_.smoothness == Smoothness::kDiscontinuous) return;
  constexpr double kStep = 0x1p-22;
  for (int i = 0; i < 4; ++i) {
    const Point3 p = RandomPoint(random_, false, 1);
    const Vector3 d = {p.x, p.y, p.z};
    const Rgb there = oracle_.Evaluate(Moved(receiver_, d, kStep)).value;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double difference =
          (there[channel] - derivatives_.irradiance.value[channel]) / kStep;
      EXPECT_NEAR(OneSided(derivatives_, channel, d), difference, 2e-4)
          << channel;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OnRandomScenes, ::testing::Range(0, 60));

TEST(Derivatives, RandomScenesAreOfAllKinds) {
  int kinks = 0;
  int lit = 0;
  for (int i = 0; i < 60; ++i) {
    PortableRandom random(static_cast<std::uint64_t>(i) + 900);
    const Scene scene = MakeScene(RandomScene(random, i % 2 == 0, 14));
    const Derivatives d =
        Oracle(scene).Derivatives(RandomReceiver(random, i % 2 == 0));
    kinks += d.smoothness == Smoothness::kKink ? 1 : 0;
    lit += d.irradiance.value != Rgb{} ? 1 : 0;
  }
  EXPECT_GT(kinks, 3);
  EXPECT_GT(lit, 30);
}

// Under the middle of a square everything sideways is exactly zero.
TEST(Derivatives, SymmetryGivesExactZeros) {
  const Scene scene =
      MakeScene({{Ceiling(-1, 1, -1, 1, 2), kLamp},
                 {Ceiling(-0.25, 0.25, -0.25, 0.25, 1), kBlack}});
  const Derivatives d = Oracle(scene).Derivatives({{0, 0, 0}, {0, 0, 1}, 0});
  EXPECT_EQ(d.undecided, 0);
  EXPECT_EQ(d.smoothness, Smoothness::kC1);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const ChannelDerivatives& c = d.channels[channel];
    EXPECT_EQ(c.gradient.x, 0);
    EXPECT_EQ(c.gradient.y, 0);
    EXPECT_GT(std::fabs(c.gradient.z), 0.01 * kLamp[channel]);
    EXPECT_EQ(c.tangential, Vector3{});
    EXPECT_EQ(c.normal, Vector3{});
    EXPECT_EQ(c.vector.x, 0);
    EXPECT_EQ(c.vector.z, d.irradiance.value[channel]);
    EXPECT_EQ(c.jacobian[0][0], c.jacobian[1][1]);
    EXPECT_EQ(c.jacobian[0][1], 0);
    EXPECT_EQ(c.jacobian[2][2], c.gradient.z);
  }
}

// One edge of the blocker covers one of the lamp: what is beside the receiver
// on one side sees more, on the other nothing changes.
TEST(Derivatives, ACoveredEdgeIsAKink) {
  const Scene scene = MakeScene(
      {{Ceiling(0, 2, -1, 1, 2), kLamp}, {Ceiling(0, 0.5, -1, 1, 1), kBlack}});
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const Oracle oracle(scene);
  const Derivatives d = oracle.Derivatives(receiver);
  ASSERT_EQ(d.smoothness, Smoothness::kKink);
  ASSERT_EQ(d.kinks.size(), 1U);
  EXPECT_EQ(d.kinks[0].normal, (Vector3{1, 0, 0}));
  EXPECT_TRUE(d.kinks[0].faces.empty());
  for (const double side : {-1.0, 1.0}) {
    const Vector3 step = {side, 0, 0};
    const double difference =
        (oracle.Evaluate(Moved(receiver, step, 0x1p-20)).value[0] -
         d.irradiance.value[0]) /
        0x1p-20;
    EXPECT_NEAR(OneSided(d, 0, step), difference, 1e-5);
  }
}

// In the plane of a lamp E is 0, but on one side it begins to rise.
TEST(Derivatives, NothingIsSeenBesideSomething) {
  const Scene scene = MakeScene({{Ceiling(1, 2, -1, 1, 0), kLamp}});
  const Derivatives d = Oracle(scene).Derivatives({{0, 0, 0}, {1, 0, 0}, 0});
  EXPECT_EQ(d.irradiance.value, Rgb{});
  ASSERT_EQ(d.smoothness, Smoothness::kKink);
  ASSERT_EQ(d.kinks.size(), 1U);
  EXPECT_EQ(d.kinks[0].faces, std::vector<int>{1});
  // Below the lamp it is seen, above it shows its back.
  const double g = d.channels[0].gradient.z;
  EXPECT_LT(g, 0);
  EXPECT_NEAR(g, -d.kinks[0].size[0], 1e-15);
}

// The line of an edge goes through the receiver, whose coordinates have bits
// far below those of the scene: beside it the line is very near, and sums lose
// thousands of bits.
TEST(Derivatives, OnTheLineOfAnEdge) {
  const Scene scene =
      MakeScene({{Ceiling(-2, 6, -2, 6, 4), kLamp},
                 {{{2, 0, 1}, {3, 0, 1}, {3, 1, 1}, {2, 1, 1}}},
                 {{{2, 0, 1}, {3, 0, 1}, {3, 0, 2}, {2, 0, 2}}}});
  const Receiver receiver{{1e-7, 0, 1}, {0.25, 0, 1}, 0};
  const Oracle oracle(scene);
  const Derivatives d = oracle.Derivatives(receiver);
  ASSERT_EQ(d.smoothness, Smoothness::kKink);
  for (const Vector3& step :
       {Vector3{0.5, 1, 0.25}, Vector3{0.5, -1, 0.25}, Vector3{0.5, 1, -0.25},
        Vector3{0.5, -1, -0.25}, Vector3{-1, 0.125, 1}}) {
    const double difference =
        (oracle.Evaluate(Moved(receiver, step, 0x1p-20)).value[0] -
         d.irradiance.value[0]) /
        0x1p-20;
    EXPECT_NEAR(OneSided(d, 0, step), difference, 1e-5);
  }
}

TEST(Derivatives, OnAFaceThereAreNone) {
  const Scene scene = MakeScene(
      {{Ceiling(-1, 1, -1, 1, 2), kLamp}, {Floor(-1, 1, -1, 1, 0), kBlack}});
  const Oracle oracle(scene);
  // Level with its face it is as if the face were not there.
  EXPECT_EQ(oracle.Derivatives({{0.1, 0, 0}, {0, 0, 1}, 0}).smoothness,
            Smoothness::kC1);
  EXPECT_EQ(oracle.Derivatives({{0.1, 0, 0}, {1, 0, 1}, 0}).smoothness,
            Smoothness::kDiscontinuous);
  EXPECT_EQ(oracle.Derivatives({{0.1, 0, 0}, {1, 0, 1}, 2}).smoothness,
            Smoothness::kC1);
}

TEST(Derivatives, RadianceIsPiTimesAsMuch) {
  const Scene scene = MakeScene({{Ceiling(0, 1, 0, 2, 1), kLamp}});
  const Receiver receiver{{0.3, -0.2, 0}, {0, 0.5, 1}, 0};
  const Derivatives m = Oracle(scene).Derivatives(receiver);
  const Derivatives l =
      Oracle(scene, {.emission = Emission::kRadiance}).Derivatives(receiver);
  constexpr double kPi = 3.141592653589793;
  EXPECT_NEAR(l.channels[0].gradient.x, kPi * m.channels[0].gradient.x, 1e-15);
  EXPECT_NEAR(l.channels[1].sphere_jacobian[2][1],
              kPi * m.channels[1].sphere_jacobian[2][1], 1e-15);
}

}  // namespace
}  // namespace truelux
