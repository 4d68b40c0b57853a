// SPDX-License-Identifier: GPL-3.0-or-later
// The last step: ties, subnormal results, overflow, zeros, and which stage
// answers.

#include "radiometry/stages/rounding.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "radiometry/hand_contour.h"
#include "radiometry/random_polygons.h"
#include "radiometry/reference.h"

namespace truelux::testing {
namespace {

constexpr EvaluationQuery kCertified{};
constexpr EvaluationQuery kRadiance{Method::kCertified, Emission::kRadiance,
                                    Formula::kAuto};
constexpr EvaluationQuery kPlain{Method::kDouble, Emission::kExitance,
                                 Formula::kAuto};
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

/// One octant of the sphere per emission: E = (sum of M) / 4.
HandContour Octants(const std::vector<Rgb>& emissions) {
  const std::vector<Point3> corners = {
      {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  HandContour contour({0, 0, 0}, {0, 0, 1});
  for (std::size_t i = 0; i < emissions.size(); ++i) {
    contour.AddConvexPolygon({{0, 0, 1}, corners[(i + 1) % 4], corners[i]},
                             emissions[i]);
  }
  return contour;
}

TEST(Rounding, TieGoesToEvenAndIsCounted) {
  const Rgb one{1, 1, 1};
  const Rgb tiny{0x1p-53, 3 * 0x1p-53, 5 * 0x1p-53};
  const Irradiance result =
      Octants({one, tiny, one, tiny}).Evaluate(kCertified);
  // 1/2 + k 2^-54 for k = 1, 3, 5, between multiples of 2^-53.
  EXPECT_EQ(result.value[0], 0.5);
  EXPECT_EQ(result.value[1], 0.5 + 0x1p-52);
  EXPECT_EQ(result.value[2], 0.5 + 0x1p-52);
  EXPECT_EQ(result.statistics.ties, 3U);
  EXPECT_EQ(result.statistics.evaluated_multiprecision, 1U);
  EXPECT_EQ(result.statistics.max_precision_bits, 4096U);
  EXPECT_EQ(result.bound[0], 0x1p-54);
}

TEST(Rounding, NearlyATieIsNone) {
  const Rgb one{1, 1, 1};
  const Rgb tiny{0x1.0000000000001p-53, 0x1.fffffffffffffp-54, 0};
  const Irradiance result =
      Octants({one, tiny, one, tiny}).Evaluate(kCertified);
  EXPECT_EQ(result.value[0], 0.5 + 0x1p-53);
  EXPECT_EQ(result.value[1], 0.5);
  EXPECT_EQ(result.value[2], 0.5);
  EXPECT_EQ(result.statistics.ties, 0U);
}

TEST(Rounding, SubnormalResultsAreRoundedOnce) {
  const Irradiance ties =
      Octants({{6 * kLeast, 10 * kLeast, 2 * kLeast}}).Evaluate(kCertified);
  EXPECT_EQ(ties.value, (Rgb{2 * kLeast, 2 * kLeast, 0}));
  EXPECT_EQ(ties.statistics.ties, 3U);
  EXPECT_EQ(ties.bound[2], kLeast);
  const Irradiance plain =
      Octants({{4 * kLeast, 3 * kLeast, kLeast}}).Evaluate(kCertified);
  EXPECT_EQ(plain.value, (Rgb{kLeast, kLeast, 0}));
  EXPECT_EQ(plain.statistics.ties, 0U);
  EXPECT_FALSE(std::signbit(plain.value[2]));
}

TEST(Rounding, SubnormalResultsEqualTheReference) {
  const std::vector<Point3> ring = {
      {-1, -1, 1}, {-1, 2, 1}, {1, 2, 1.5}, {1, -1, 1.5}};
  const Real factor = FormFactor(ring, {0, 0, 0}, {0, 0, 1});
  for (int k = 1; k < 60; ++k) {
    const double m = std::ldexp(1.7, -1022 - k);
    HandContour contour({0, 0, 0}, {0, 0, 1});
    contour.AddConvexPolygon(ring, {m, 3 * m, 5 * m});
    const Irradiance certified = contour.Evaluate(kCertified);
    const Irradiance plain = contour.Evaluate(kPlain);
    for (const double c : {0, 1, 2}) {
      const auto i = static_cast<std::size_t>(c);
      const Real truth = Real((2 * c + 1) * m) * factor;
      EXPECT_EQ(certified.value[i], truth.ToDouble()) << k;
      EXPECT_LE(Abs(Real(plain.value[i]) - truth), Real(plain.bound[i])) << k;
    }
  }
}

TEST(Rounding, TooLargeIsInfinityAndCounted) {
  const Rgb m{kMost, kMost / 4, 1};
  const HandContour contour = Octants({m, m, m, m});
  const Irradiance radiant = contour.Evaluate(kRadiance);
  EXPECT_TRUE(std::isinf(radiant.value[0]));
  EXPECT_TRUE(std::isinf(radiant.bound[0]));
  EXPECT_EQ(radiant.value[1], (Real::Pi() * Real(kMost / 4)).ToDouble());
  EXPECT_EQ(radiant.statistics.overflows, 1U);
  const Irradiance exitant = contour.Evaluate(kCertified);
  EXPECT_EQ(exitant.value[0], kMost);
  EXPECT_EQ(exitant.bound[0], 0x1p970);
  EXPECT_EQ(exitant.statistics.overflows, 0U);
}

TEST(Rounding, PlainDoubleBoundsBrightAndFaintSources) {
  const Rgb m{kMost / 2, 1, 0x1p-900};
  const Irradiance result = Octants({m, m, m, m}).Evaluate(kPlain);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LE(std::fabs(result.value[c] - m[c]), result.bound[c]);
    EXPECT_LE(result.bound[c], 1e-14 * m[c]);
  }
  EXPECT_EQ(result.statistics.evaluated_double, 1U);
}

// Where plain double cannot bound a channel the next stages answer it.
TEST(Rounding, PlainDoubleNeverAnswersNaN) {
  const Rgb m{kMost, 1, kLeast};
  const Irradiance result =
      Octants({m, m, m, m})
          .Evaluate({Method::kDouble, Emission::kRadiance, Formula::kAuto});
  EXPECT_TRUE(std::isinf(result.value[0]));
  EXPECT_TRUE(std::isinf(result.bound[0]));
  EXPECT_NEAR(result.value[1], 3.141592653589793, result.bound[1]);
  EXPECT_LE(result.bound[1], 1e-13);
  EXPECT_LE(std::fabs(result.value[2] - 3 * kLeast), result.bound[2]);
  EXPECT_EQ(result.statistics.evaluated_multiprecision, 1U);
  EXPECT_EQ(result.statistics.evaluated_double, 0U);
  EXPECT_EQ(result.statistics.overflows, 1U);
}

TEST(Rounding, NothingLitIsExactlyZero) {
  const Irradiance dark = Octants({{0, 0, 0}}).Evaluate(kCertified);
  EXPECT_EQ(dark.value, (Rgb{0, 0, 0}));
  EXPECT_EQ(dark.bound, (Rgb{0, 0, 0}));
  EXPECT_EQ(dark.statistics.evaluated_zero, 1U);
  const Irradiance empty = Octants({}).Evaluate(kPlain);
  EXPECT_EQ(empty.statistics.evaluated_zero, 1U);
  const Irradiance red = Octants({{1, 0, 0}}).Evaluate(kCertified);
  EXPECT_EQ(red.value, (Rgb{0.25, 0, 0}));
  EXPECT_EQ(red.bound[1], 0);
  EXPECT_GT(red.bound[0], 0);
}

TEST(Stages, OrdinaryContoursNeverReachMultiprecision) {
  PortableRandom random(31);
  for (int i = 0; i < 300; ++i) {
    const RandomView view = MakeRandomView(random, random.Uniform(0.01, 1),
                                           random.Uniform(0.2, 1.5), 0);
    for (const Ends ends : {Ends::kNatural, Ends::kCrossings}) {
      HandContour contour(view.position, view.normal);
      contour.AddConvexPolygon(view.ring, {1, 2, 3}, ends);
      const Irradiance result = contour.Evaluate(kCertified);
      EXPECT_EQ(result.statistics.evaluated_double_double, 1U);
      EXPECT_EQ(contour.Evaluate(kPlain).statistics.evaluated_double, 1U);
    }
  }
}

// Whole edges keep their relative accuracy; crossings lose it to the size.
TEST(Stages, TinyContoursWithApparentEndsDo) {
  PortableRandom random(32);
  int whole_edges = 0;
  int crossings = 0;
  for (int i = 0; i < 100; ++i) {
    const RandomView view =
        MakeRandomView(random, 1e-12, random.Uniform(0.2, 1.5), 0);
    for (const Ends ends : {Ends::kNatural, Ends::kCrossings}) {
      HandContour contour(view.position, view.normal);
      contour.AddConvexPolygon(view.ring, {1, 1, 1}, ends);
      const Statistics s = contour.Evaluate(kCertified).statistics;
      (ends == Ends::kNatural ? whole_edges : crossings) +=
          static_cast<int>(s.evaluated_multiprecision);
    }
  }
  RecordProperty("whole_edges", whole_edges);
  EXPECT_EQ(crossings, 100);
  EXPECT_LT(whole_edges, 60);
}

TEST(RoundIfCertain, RefusesABallThatHoldsAMidpoint) {
  const double half = 0x1p-53;
  using Number = Ball<DoubleDouble>;
  EXPECT_FALSE(RoundIfCertain(Number({1, half}, 0x1p-120)));
  EXPECT_FALSE(RoundIfCertain(Number({1, half - 0x1p-110}, 0x1p-109)));
  EXPECT_EQ(RoundIfCertain(Number({1, half - 0x1p-90}, 0x1p-95)), 1);
  EXPECT_EQ(RoundIfCertain(Number({1 + 0x1p-52, -half + 0x1p-90}, 0x1p-95)),
            1 + 0x1p-52);
  EXPECT_FALSE(RoundIfCertain(Unbounded<DoubleDouble>()));
}

TEST(HalfSpacing, IsHalfTheWayToTheFartherNeighbour) {
  EXPECT_EQ(HalfSpacing(1), 0x1p-53);
  EXPECT_EQ(HalfSpacing(std::nextafter(1, 0)), 0x1p-54);
  EXPECT_EQ(HalfSpacing(0x1p-1022), kLeast);
  EXPECT_EQ(HalfSpacing(0x1p-1021), kLeast);
  EXPECT_EQ(HalfSpacing(0x1p-1020), 2 * kLeast);
  EXPECT_EQ(HalfSpacing(0), kLeast);
  EXPECT_EQ(HalfSpacing(kMost), 0x1p970);
  EXPECT_TRUE(std::isinf(HalfSpacing(HUGE_VAL)));
}

}  // namespace
}  // namespace truelux::testing
