// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter of a crossing: its bound, and the order that it tells.

#include "exact/crossing.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

Exact Abs(const Exact& x) {
  return x < Exact(0) ? -x : x;
}

/// A crossing and the true |A.u| and |A.v|, anywhere in their bounds.
struct Sample {
  Crossing crossing;
  Exact from;
  Exact to;
};

Sample RandomCrossing(PortableRandom& random, int range) {
  const auto side = [&](Sign sign, Exact& truth) {
    const double size =
        std::ldexp(random.Uniform(0.5, 1), random.Integer(-range, range));
    const double error = std::ldexp(size, random.Integer(-60, -1));
    truth = Exact(size) + Exact(error) * Exact(random.Integer(-1, 1));
    const double value = sign == Sign::kPositive ? size : -size;
    return Side{sign, {value, error}};
  };
  Sample sample;
  const Sign sign = random.OneIn(2) ? Sign::kPositive : Sign::kNegative;
  const Side from = side(sign, sample.from);
  const Side to = side(-sign, sample.to);
  const RoundUpward rounding;
  sample.crossing = MakeCrossing(ViewPlaneId(7), from, to);
  return sample;
}

TEST(Crossing, ParameterIsWithinItsBound) {
  PortableRandom random(1);
  int bounded = 0;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Sample s = RandomCrossing(random, i % 2 == 0 ? 3 : 300);
    if (!std::isfinite(s.crossing.error)) continue;
    ++bounded;
    // |t - f / (f + g)| <= e, times f + g.
    const Exact sum = s.from + s.to;
    const Exact error = Abs(Exact(s.crossing.parameter) * sum - s.from);
    ASSERT_TRUE(error <= Exact(s.crossing.error) * sum) << "sample " << i;
    const double allowed = (Exact(s.crossing.error) * sum).to_double();
    if (allowed > 0) worst = std::max(worst, error.to_double() / allowed);
  }
  EXPECT_GT(bounded, 50000);
  EXPECT_GT(worst, 0.3) << "the bound is far from tight";
}

TEST(Crossing, OrderIsTheTrueOneOrNotKnown) {
  PortableRandom random(2);
  int known = 0;
  int unknown = 0;
  for (int i = 0; i < 50000; ++i) {
    const Sample a = RandomCrossing(random, 2);
    Sample b = RandomCrossing(random, 2);
    if (i % 4 == 0) b = a;
    const RoundUpward rounding;
    const auto order = TryOrder(a.crossing, b.crossing);
    if (!order) {
      ++unknown;
      continue;
    }
    ++known;
    // f_a / (f_a + g_a) against f_b / (f_b + g_b).
    EXPECT_EQ(*order, SignOf(a.from * b.to - b.from * a.to));
    EXPECT_EQ(TryOrder(b.crossing, a.crossing), -*order);
  }
  EXPECT_GT(known, 20000);
  EXPECT_GT(unknown, 12000);
}

TEST(Crossing, WithoutABoundNothingIsKnown) {
  const RoundUpward rounding;
  // The filter's value is below its error: some other stage found the sign.
  const Side vague{Sign::kPositive, {1e-30, 1}};
  const Side sure{Sign::kNegative, {-1, 1e-16}};
  const Side infinite{Sign::kPositive, {HUGE_VAL, HUGE_VAL}};
  const Side none{Sign::kPositive, {0, 0}};
  const Crossing good =
      MakeCrossing(ViewPlaneId(1), {Sign::kPositive, {1e9, 1e-7}}, sure);
  ASSERT_TRUE(std::isfinite(good.error));
  for (const Crossing& c :
       {MakeCrossing(ViewPlaneId(0), vague, sure),
        MakeCrossing(ViewPlaneId(0), infinite, sure),
        MakeCrossing(ViewPlaneId(0), none, {Sign::kNegative, {0, 0}})}) {
    EXPECT_FALSE(TryOrder(c, good).has_value());
    EXPECT_FALSE(TryOrder(good, c).has_value());
    EXPECT_FALSE(TryOrder(c, c).has_value());
  }
}

}  // namespace
}  // namespace truelux
