// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of the double filter, derived again and tried to break.

#include "exact/filter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "exact/approximation.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

Exact Abs(const Exact& x) {
  return x < Exact(0) ? -x : x;
}

TEST(Filter, DotFactorCoversThreeRoundings) {
  const Exact unit(kDirectedUnit);
  const Exact one(1);
  const Exact growth = (one + unit) * (one + unit) * (one + unit) - one;
  EXPECT_TRUE(growth < Exact(kDotFactor));
  EXPECT_TRUE(Exact(kDotFactor / 2) < growth);
}

TEST(Filter, DotFloorCoversThreeUnderflows) {
  EXPECT_GE(kDotFloor, 3 * 0x1p-1074);
}

/// A number of random sign and exponent within +-range of 2^0.
double RandomNumber(PortableRandom& random, int range) {
  return std::ldexp(random.Uniform(-1, 1), random.Integer(-range, range));
}

struct Sample {
  BoundedValue value;
  Exact truth;
};

/// A dot product of two vectors whose approximations are off by at most their
/// stated errors.
Sample RandomDot(PortableRandom& random, int range, bool exact_input) {
  const RoundUpward rounding;
  double p[3];
  double d[3];
  double p_error = 0;
  double d_error = 0;
  Exact truth(0);
  for (int k = 0; k < 3; ++k) {
    p[k] = RandomNumber(random, range);
    d[k] = RandomNumber(random, range);
  }
  if (!exact_input) {
    p_error = std::fabs(p[0]) * 0x1p-50;
    d_error = std::fabs(d[1]) * 0x1p-51;
  }
  if (random.OneIn(2)) {  // almost orthogonal
    const double last = -(p[0] * d[0] + p[1] * d[1]) / d[2];
    if (std::isfinite(last)) p[2] = last;
  }
  for (int k = 0; k < 3; ++k) {
    const Exact true_p =
        Exact(p[k]) + Exact(p_error) * Exact(random.Integer(-1, 1));
    const Exact true_d =
        Exact(d[k]) + Exact(d_error) * Exact(random.Integer(-1, 1));
    truth = truth + true_p * true_d;
  }
  const FilteredPlane plane = MakeFilteredPlane({p[0], p[1], p[2], p_error});
  const FilteredDirection direction =
      MakeFilteredDirection({d[0], d[1], d[2], d_error});
  return {FilteredDot(plane, direction), truth};
}

TEST(Filter, DotBoundHoldsForAnyExponents) {
  PortableRandom random(1);
  double worst = 0;
  int decided = 0;
  int checked = 0;
  for (int i = 0; i < 60000; ++i) {
    const int range = i % 3 == 0 ? 2 : (i % 3 == 1 ? 60 : 520);
    const Sample s = RandomDot(random, range, i % 2 == 0);
    if (!std::isfinite(s.value.error) || !std::isfinite(s.value.value)) {
      EXPECT_FALSE(TrySign(s.value).has_value());
      continue;
    }
    ++checked;
    const Exact error = Abs(Exact(s.value.value) - s.truth);
    ASSERT_TRUE(error <= Exact(s.value.error)) << "sample " << i;
    worst = std::max(worst, error.to_double() / s.value.error);
    if (const auto sign = TrySign(s.value)) {
      ++decided;
      ASSERT_EQ(*sign, SignOf(s.truth)) << "sample " << i;
    }
  }
  EXPECT_GT(checked, 40000);
  EXPECT_GT(decided, 10000);
  EXPECT_LT(decided, checked);
  EXPECT_GT(worst, 0.1) << "the bound is far from tight";
}

TEST(Filter, CrossBoundHoldsForAnyExponents) {
  PortableRandom random(2);
  int checked = 0;
  double worst = 0;
  for (int i = 0; i < 40000; ++i) {
    const int range = i % 3 == 0 ? 2 : (i % 3 == 1 ? 60 : 500);
    std::array<std::array<double, 3>, 2> v{};
    std::array<std::array<Exact, 3>, 2> truth;
    std::array<double, 2> error{};
    for (std::size_t k = 0; k < 2; ++k) {
      double max = 0;
      for (double& c : v[k]) {
        c = RandomNumber(random, range);
        max = std::max(max, std::fabs(c));
      }
      // Every third pair is almost parallel.
      if (k == 1 && i % 3 == 0) v[1] = {v[0][0] * 2, v[0][1] * 2, v[0][2]};
      error[k] = random.OneIn(3) ? 0 : max * kDirectedUnit;
      for (std::size_t c = 0; c < 3; ++c) {
        truth[k][c] =
            Exact(v[k][c]) + Exact(error[k]) * Exact(random.Integer(-1, 1));
      }
    }
    const RoundUpward rounding;
    const ApproxVector cross = FilteredCross(
        MakeFilteredDirection({v[0][0], v[0][1], v[0][2], error[0]}),
        MakeFilteredDirection({v[1][0], v[1][1], v[1][2], error[1]}));
    if (!std::isfinite(cross.error)) continue;
    ++checked;
    const Vec3<Exact> exact =
        Cross(Vec3<Exact>{truth[0][0], truth[0][1], truth[0][2]},
              Vec3<Exact>{truth[1][0], truth[1][1], truth[1][2]});
    for (const Exact& e :
         {Abs(Exact(cross.x) - exact.x), Abs(Exact(cross.y) - exact.y),
          Abs(Exact(cross.z) - exact.z)}) {
      ASSERT_TRUE(e <= Exact(cross.error)) << "sample " << i;
      worst = std::max(worst, e.to_double() / cross.error);
    }
  }
  EXPECT_GT(checked, 30000);
  EXPECT_GT(worst, 0.3) << "the bound is far from tight";
}

TEST(Filter, CrossWithoutBoundDecidesNothing) {
  const RoundUpward rounding;
  const FilteredDirection big = MakeFilteredDirection({0x1p600, 0, 0, 0});
  const FilteredDirection other = MakeFilteredDirection({0, 0x1p600, 0, 0});
  EXPECT_EQ(FilteredCross(big, other).error, HUGE_VAL);
  const FilteredDirection lost = MakeFilteredDirection({0, 1, 0, HUGE_VAL});
  EXPECT_FALSE(FilteredCross(big, lost).error < HUGE_VAL);
}

TEST(Filter, ApproximationHoldsTheInterval) {
  const RoundUpward rounding;
  const double big = 0x1p1023;
  const Vec3<Interval> wide{Interval(-big, big), Interval(1, 1),
                            Interval(0, 0)};
  const ApproxVector a = Approximate(wide);
  EXPECT_FALSE(std::isfinite(a.error) && a.error < big);
  const Vec3<Interval> point{Interval(3), Interval(-4), Interval(0)};
  const ApproxVector b = Approximate(point);
  EXPECT_EQ(b.error, 0);
  EXPECT_EQ(b.y, -4);
}

TEST(Filter, InfiniteIntervalDecidesNothing) {
  const RoundUpward rounding;
  const double inf = HUGE_VAL;
  const FilteredPlane plane = MakeFilteredPlane(
      Approximate({Interval(inf, inf), Interval(0), Interval(0)}));
  const FilteredDirection d = MakeFilteredDirection({1, 0, 0, 0});
  EXPECT_FALSE(TrySign(FilteredDot(plane, d)).has_value());
}

TEST(Filter, NegativeOverflowDecidesNothing) {
  const RoundUpward rounding;
  // -2^1030 + 1.9 * 2^1023: the first product becomes -DBL_MAX.
  const FilteredPlane plane = MakeFilteredPlane({-0x1p520, 0x1.9p513, 0, 0});
  const FilteredDirection d = MakeFilteredDirection({0x1p510, 0x1p510, 0, 0});
  EXPECT_FALSE(TrySign(FilteredDot(plane, d)).has_value());
  const double big = 0x1.8p1023;
  const FilteredDirection wide = FilteredDifference({big, 0, 0}, {-big, 0, 0});
  const FilteredPlane x = MakeFilteredPlane({0x1p-200, 0, 0, 0});
  EXPECT_FALSE(TrySign(FilteredDot(x, wide)).has_value());
}

TEST(Filter, DifferenceBoundHolds) {
  PortableRandom random(2);
  const RoundUpward rounding;
  for (int i = 0; i < 20000; ++i) {
    const Point3 a{RandomNumber(random, 40), RandomNumber(random, 40),
                   RandomNumber(random, 40)};
    const Point3 b{RandomNumber(random, 40), RandomNumber(random, 40),
                   RandomNumber(random, 40)};
    const FilteredDirection d = FilteredDifference(a, b);
    ASSERT_TRUE(Abs(Exact(d.v.x) - (Exact(b.x) - Exact(a.x))) <=
                Exact(d.v.error));
    ASSERT_TRUE(Abs(Exact(d.v.y) - (Exact(b.y) - Exact(a.y))) <=
                Exact(d.v.error));
    ASSERT_TRUE(Abs(Exact(d.v.z) - (Exact(b.z) - Exact(a.z))) <=
                Exact(d.v.error));
  }
}

}  // namespace
}  // namespace truelux
