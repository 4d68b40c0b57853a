// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives in double keep within their bounds. A night's run of 100,000
// receivers: TRUELUX_LONG_TEST=545, and the table of docs/derivatives.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "radiometry/derivatives/hard_scenes.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr int kReceiversOfScene = 20;

/// The numbers of ChannelDerivatives by quantities.
enum Quantity : std::size_t {  // NOLINT(cert-enum): indices
  kGradient,
  kByNormal,
  kVector,
  kJacobian,
  kSphere,
  kFlux,
  kQuantityCount,
};

constexpr std::array<std::string_view, kQuantityCount> kQuantityNames = {
    "gradient", "dE/dn", "V", "J", "sphere", "flux"};

struct Number {
  Quantity quantity;
  double value;
};

std::vector<Number> NumbersOf(const ChannelDerivatives& c) {
  std::vector<Number> all;
  const auto add = [&all](Quantity quantity, const Vector3& v) {
    for (const double x : {v.x, v.y, v.z})
      all.push_back({quantity, x});
  };
  add(kGradient, c.gradient);
  add(kGradient, c.tangential);
  add(kByNormal, c.normal);
  add(kVector, c.vector);
  add(kSphere, c.sphere);
  all.push_back({kFlux, c.flux});
  for (std::size_t p = 0; p < 3; ++p) {
    add(kJacobian, {c.jacobian[p][0], c.jacobian[p][1], c.jacobian[p][2]});
    add(kSphere, {c.sphere_jacobian[p][0], c.sphere_jacobian[p][1],
                  c.sphere_jacobian[p][2]});
  }
  return all;
}

/// What was seen of one kind of scenes.
struct Record {
  int receivers = 0;
  int lit = 0;
  int kinks = 0;
  long numbers = 0;     ///< given by sums in double
  long violations = 0;  ///< beyond their bounds
  std::array<double, kQuantityCount> largest_ratio{};  ///< error / bound
  std::array<long, kQuantityCount> counts{};
};

void Compare(const Derivatives& plain, const Derivatives& certified,
             Record& record) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto got = NumbersOf(plain.channels[channel]);
    const auto bounds = NumbersOf(plain.bounds[channel]);
    const auto want = NumbersOf(certified.channels[channel]);
    const auto slack = NumbersOf(certified.bounds[channel]);
    for (std::size_t i = 0; i < got.size(); ++i) {
      // At kinks, and where double has no bound, it is the certified number.
      const bool is_certified = bounds[i].value == slack[i].value;
      // 5e-324 m beside an edge both are infinite.
      const double error = got[i].value == want[i].value
                               ? 0
                               : std::fabs(got[i].value - want[i].value);
      // The truth is within half an ulp of the certified number.
      if (!(error <= bounds[i].value + slack[i].value)) ++record.violations;
      if (is_certified) continue;
      ++record.numbers;
      ++record.counts[got[i].quantity];
      double& largest = record.largest_ratio[got[i].quantity];
      largest = std::max(largest, error / bounds[i].value);
    }
  }
}

Record Sweep(Hardness hardness, int scenes) {
  Record record;
  for (int seed = 0; seed < scenes; ++seed) {
    HardSceneMaker maker(hardness, static_cast<std::uint64_t>(seed) * 64 +
                                       static_cast<std::uint64_t>(hardness));
    const HardScene hard = maker.Make(kReceiversOfScene);
    const Scene scene = MakeScene(hard.faces);
    const Oracle certified(scene);
    const Oracle plain(scene, {.method = Method::kDouble});
    for (const Receiver& receiver : hard.receivers) {
      const Derivatives truth = certified.Derivatives(receiver);
      if (truth.smoothness == Smoothness::kDiscontinuous) continue;
      ++record.receivers;
      record.lit += truth.irradiance.value == Rgb{} ? 0 : 1;
      record.kinks += truth.smoothness == Smoothness::kKink ? 1 : 0;
      Compare(plain.Derivatives(receiver), truth, record);
    }
  }
  return record;
}

/// Where limits are needed a receiver costs a hundred times as much.
int ScenesOf(Hardness hardness, int all) {
  const bool is_slow =
      hardness == Hardness::kOnLattice || hardness == Hardness::kNoise;
  return is_slow ? std::max(all / 10, 3) : all;
}

void Print(std::string_view name, const Record& record) {
  std::cout << "| " << name << " | " << record.receivers << " | " << record.lit
            << " | " << record.kinks << " | " << record.numbers << " | "
            << record.violations << std::setprecision(2);
  for (const double ratio : record.largest_ratio)
    std::cout << " | " << ratio;
  std::cout << " |" << std::endl;
}

TEST(DoubleBounds, HoldForEveryComponent) {
  const int all = SweepSize(24, 100);
  std::cout << "| scenes | receivers | lit | kinks | numbers | violations";
  for (const std::string_view name : kQuantityNames)
    std::cout << " | " << name;
  std::cout << " |\n";
  for (const auto& [hardness, name] : kHardnesses) {
    const Record record = Sweep(hardness, ScenesOf(hardness, all));
    Print(name, record);
    EXPECT_EQ(record.violations, 0) << name;
    EXPECT_GT(record.receivers, ScenesOf(hardness, all) * 10) << name;
    EXPECT_GT(record.lit, record.receivers / 4) << name;
    for (std::size_t q = 0; q < kQuantityCount; ++q) {
      EXPECT_GT(record.counts[q], record.lit) << name << kQuantityNames[q];
      // A bound that is never approached would say nothing of the sums.
      EXPECT_GT(record.largest_ratio[q], 1e-3) << name << kQuantityNames[q];
    }
    if (hardness == Hardness::kOnLattice) {
      EXPECT_GT(record.kinks, 0);
    }
  }
}

}  // namespace
}  // namespace truelux
