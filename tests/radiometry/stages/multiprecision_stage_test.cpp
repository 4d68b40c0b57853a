// SPDX-License-Identifier: GPL-3.0-or-later
// The last stage beside its twin in plain MPFR: both enclose the same number.

#include "radiometry/stages/multiprecision_stage.h"

#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/hand_contour.h"
#include "radiometry/random_polygons.h"
#include "radiometry/stages/mpfr_stage.h"
#include "radiometry/stages/rounding.h"

namespace truelux::testing {
namespace {

constexpr Rgb kEmission{1, 0.3, 7e5};

/// The two stages of one contour.
struct Twins {
  MultiprecisionStage stage;
  MpfrStage twin;
};

Twins TwinsOf(const HandContour& contour, const EvaluationQuery& evaluation) {
  const WeightedContour weighted = contour.Weighted();
  const HorizonPlanes on_horizon = PlanesOnHorizon(weighted);
  return {MultiprecisionStage(weighted, evaluation, on_horizon),
          MpfrStage(ExactSumOf(weighted, evaluation, on_horizon),
                    evaluation.emission)};
}

/// Checks that both hold a number in common, and that the stage's enclosure is
/// not much wider than the one bounded by hand.
void ExpectSameNumber(const Twins& twins, mpfr_prec_t precision) {
  const auto a = twins.stage.Evaluate(precision);
  const auto b = twins.twin.Evaluate(precision);
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_TRUE(mpfr_lessequal_p(a[c].lower.get(), b[c].upper.get()));
    ASSERT_TRUE(mpfr_lessequal_p(b[c].lower.get(), a[c].upper.get()));
    const Multiprecision own = a[c].upper - a[c].lower;
    const Multiprecision four_of_twin =
        (b[c].upper - b[c].lower) * Multiprecision(precision, 4.0);
    ASSERT_GE(mpfr_sgn(own.get()), 0);
    ASSERT_TRUE(mpfr_lessequal_p(own.get(), four_of_twin.get()));
  }
}

/// Checks that both overlap and that the inner one is narrower.
void ExpectNarrower(const Enclosure& outer, const Enclosure& inner) {
  EXPECT_TRUE(mpfr_lessequal_p(outer.lower.get(), inner.upper.get()));
  EXPECT_TRUE(mpfr_lessequal_p(inner.lower.get(), outer.upper.get()));
  const Multiprecision outer_width = outer.upper - outer.lower;
  const Multiprecision inner_width = inner.upper - inner.lower;
  EXPECT_TRUE(mpfr_less_p(inner_width.get(), outer_width.get()));
}

class StageOfSize : public ::testing::TestWithParam<double> {};

TEST_P(StageOfSize, EnclosesTheNumberThatItsTwinEncloses) {
  PortableRandom random(41);
  const double size = GetParam();
  for (int i = 0; i < 40; ++i) {
    const RandomView view =
        MakeRandomView(random, size, size * random.Uniform(-0.2, 0.5), 0);
    for (const Ends ends : {Ends::kNatural, Ends::kCrossings}) {
      HandContour contour(view.position, view.normal);
      contour.AddConvexPolygon(view.ring, kEmission, ends);
      for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
        for (const Emission emission :
             {Emission::kExitance, Emission::kRadiance}) {
          const Twins twins =
              TwinsOf(contour, {Method::kCertified, emission, formula});
          for (const mpfr_prec_t precision : {64, 128, 1024})
            ExpectSameNumber(twins, precision);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, StageOfSize,
                         ::testing::Values(1, 1e-4, 1e-8, 1e-12));

/// A square that nothing hides.
HandContour Square() {
  HandContour contour({0, 0, 0}, {0, 0, 1});
  contour.AddConvexPolygon({{-1, -1, 1}, {-1, 2, 1}, {1, 2, 1}, {1, -1, 1}},
                           kEmission);
  return contour;
}

TEST(MultiprecisionStage, EnclosuresShrinkWithThePrecision) {
  const HandContour contour = Square();
  const Twins twins = TwinsOf(contour, {});
  std::array<Enclosure, 3> last = twins.stage.Evaluate(64);
  for (mpfr_prec_t p = 128; p <= 16384; p *= 2) {
    std::array<Enclosure, 3> next = twins.stage.Evaluate(p);
    for (std::size_t c = 0; c < 3; ++c)
      ExpectNarrower(last[c], next[c]);
    last = std::move(next);
  }
}

// Arb keeps constants per thread: threads may come and go, and the number that
// one has made may be read by another.
TEST(MultiprecisionStage, GivesTheSameInEveryThread) {
  const HandContour contour = Square();
  const Twins twins = TwinsOf(contour, {});
  const std::array<Enclosure, 3> expected = twins.stage.Evaluate(4096);
  constexpr int kThreads = 8;
  for (int round = 0; round < 4; ++round) {
    std::vector<std::array<Enclosure, 3>> found(kThreads);
    std::vector<std::thread> threads;
    for (auto& mine : found)
      threads.emplace_back([&] { mine = twins.stage.Evaluate(4096); });
    for (std::thread& thread : threads)
      thread.join();
    for (const auto& mine : found) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(mpfr_equal_p(mine[c].lower.get(), expected[c].lower.get()));
        EXPECT_TRUE(mpfr_equal_p(mine[c].upper.get(), expected[c].upper.get()));
      }
    }
  }
}

}  // namespace
}  // namespace truelux::testing
