// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/sampled.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using testing::Ceiling;
using testing::Floor;
using testing::kBlack;
using testing::kLamp;
using testing::MakeScene;

constexpr SamplePattern kStratified[] = {SamplePattern::kSobol,
                                         SamplePattern::kRowOrdered};
constexpr SamplePattern kPatterns[] = {
    SamplePattern::kSobol, SamplePattern::kRowOrdered, SamplePattern::kRandom};

/// Which of columns * rows cells each point lies in.
std::vector<std::pair<int, int>> Cells(const std::vector<SquarePoint>& points,
                                       int columns, int rows) {
  std::vector<std::pair<int, int>> cells;
  cells.reserve(points.size());
  for (const SquarePoint& point : points) {
    cells.emplace_back(static_cast<int>(point[0] * columns),
                       static_cast<int>(point[1] * rows));
  }
  return cells;
}

TEST(SquareSamples, EveryCellOfTheSquareHasOnePoint) {
  for (const SamplePattern pattern : kStratified) {
    const auto cells = Cells(SquareSamples(pattern, 256, 5), 16, 16);
    EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), 256U);
  }
}

TEST(SquareSamples, SobolIsStratifiedInOblongCellsToo) {
  const auto points = SquareSamples(SamplePattern::kSobol, 256, 7);
  for (const int columns : {1, 2, 8, 64, 256}) {
    const auto cells = Cells(points, columns, 256 / columns);
    EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), 256U);
  }
}

TEST(SquareSamples, RowByRow) {
  std::vector<std::pair<int, int>> expected;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column)
      expected.emplace_back(column, row);
  }
  EXPECT_EQ(Cells(SquareSamples(SamplePattern::kRowOrdered, 64, 1), 8, 8),
            expected);
  EXPECT_THROW(SquareSamples(SamplePattern::kRowOrdered, 65, 1),
               std::invalid_argument);
}

TEST(SquareSamples, RandomPointsFillTheSquareUnevenly) {
  const auto points = SquareSamples(SamplePattern::kRandom, 4096, 9);
  ASSERT_EQ(points.size(), 4096U);
  const auto quarters = Cells(points, 2, 2);
  for (const auto& [column, row] : std::set(quarters.begin(), quarters.end())) {
    const auto in_cell = std::ranges::count(quarters, std::pair(column, row));
    EXPECT_NEAR(static_cast<double>(in_cell), 1024, 5 * 28);
  }
  // Of 4096 cells a share of about exp(-1) stays empty.
  const auto cells = Cells(points, 64, 64);
  EXPECT_NEAR(static_cast<double>(std::set(cells.begin(), cells.end()).size()),
              4096 * (1 - std::exp(-1.0)), 200);
}

TEST(EmitterSamples, InProportionToArea) {
  // A parallelogram of area 4 and a triangle of area 1.
  const Scene scene = MakeScene({{Ceiling(0, 2, 0, 2, 1), kLamp},
                                 {{{5, 0, 1}, {5, 1, 1}, {7, 0, 1}}, kLamp}});
  const EmitterSamples samples =
      SampleEmitters(scene, SamplePattern::kSobol, 1024, 3);
  EXPECT_NEAR(samples.area, 5, 1e-12);
  ASSERT_EQ(samples.pieces.size(), 2U);
  std::ptrdiff_t on_triangle = 0;
  for (const auto& point : samples.points)
    on_triangle += point.piece;
  EXPECT_NEAR(static_cast<double>(on_triangle), 1024 / 5.0, 2);
  EXPECT_TRUE(std::ranges::all_of(samples.points, [](const auto& point) {
    const auto& [x, y, z] = point.position;
    const bool inside =
        point.piece == 0 ? x <= 2 && y <= 2 : (x - 5) / 2 + y <= 1.0001F;
    return z == 1 && inside;
  }));
}

/// How far the mean over independent sample sets is from the certified value,
/// and the standard error of that mean.
struct Deviation {
  double distance = 0;
  double sigma = 0;
};

Deviation Measure(const Scene& scene, const Receiver& receiver,
                  SamplePattern pattern) {
  constexpr int kSets = 64;
  const ShadowRays rays(scene);
  const double truth = testing::Evaluate(scene, receiver)[0];
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < kSets; ++seed) {
    const double error =
        rays.Estimate(receiver, SampleEmitters(scene, pattern, 256, seed))[0] -
        truth;
    sum += error;
    squares += error * error;
  }
  const double mean = sum / kSets;
  const double variance = (squares - sum * mean) / (kSets - 1);
  return {std::abs(mean), std::sqrt(variance / kSets)};
}

class SampledTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!ShadowRaysAvailable()) GTEST_SKIP() << "built without Embree 3";
  }

  /// Single precision adds about 1e-6 to the noise.
  static void ExpectUnbiased(const Scene& scene, const Receiver& receiver) {
    for (const SamplePattern pattern : kPatterns) {
      const Deviation deviation = Measure(scene, receiver, pattern);
      EXPECT_LT(deviation.distance, 4 * deviation.sigma + 2e-6);
      EXPECT_LT(deviation.sigma, 0.01);
    }
  }
};

const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

TEST_F(SampledTest, Unoccluded) {
  ExpectUnbiased(MakeScene({{Ceiling(-1, 0.5, -1, 1, 1), kLamp}}), kUp);
}

TEST_F(SampledTest, Occluded) {
  ExpectUnbiased(
      MakeScene({{Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kLamp},
                 {{{-0.13, -0.21, 0.5}, {0.23, -0.07, 0.45}, {0, 0.2, 0.55}},
                  kBlack}}),
      kUp);
}

TEST_F(SampledTest, ReceiverOnAFloorWithTheHorizonAcrossTheLamp) {
  ExpectUnbiased(
      MakeScene({{{{1, 1, -1}, {1, -1, -1}, {1, -1, 2}, {1, 1, 2}}, kLamp},
                 {Floor(-3, 3, -3, 3, 0), kBlack}}),
      {{0.25, 0.5, 0}, {0.1, 0, 1}, 0});
}

TEST_F(SampledTest, EmittersBlockFromBehindAndAreBlackThere) {
  ExpectUnbiased(MakeScene({{Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kLamp},
                            {Floor(-0.2, 0.1, -0.3, 0.3, 0.5), kLamp},
                            {{{2, 0, 1}, {1, 1, 2}, {2, 1, 0.5}}, kLamp}}),
                 kUp);
}

TEST_F(SampledTest, DarkWithoutEmittersAndInFullShadow) {
  const Scene dark = MakeScene({{Ceiling(-1, 1, -1, 1, 1), kBlack}});
  EXPECT_EQ(ShadowRays(dark).Estimate(
                kUp, SampleEmitters(dark, SamplePattern::kSobol, 64, 1)),
            kBlack);
  const Scene shadow = MakeScene({{Ceiling(-1, 1, -1, 1, 1), kLamp},
                                  {Ceiling(-1, 1, -1, 1, 0.5), kBlack}});
  for (const SamplePattern pattern : kPatterns) {
    EXPECT_EQ(ShadowRays(shadow).Estimate(
                  kUp, SampleEmitters(shadow, pattern, 64, 1)),
              kBlack);
  }
}

TEST(Sampled, AbsentEmbreeSaysSo) {
  if (ShadowRaysAvailable()) GTEST_SKIP() << "built with Embree 3";
  EXPECT_THROW(ShadowRays(Scene{}), std::runtime_error);
}

}  // namespace
}  // namespace truelux
