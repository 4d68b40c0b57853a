// SPDX-License-Identifier: GPL-3.0-or-later
// A ball always holds the true value: random chains of operations, each step
// checked against 1400 bits.

#include "exact/ball.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "support/portable_random.h"
#include "support/real.h"

namespace truelux::testing {
namespace {

Real ToReal(double x) {
  return {x};
}

Real ToReal(const DoubleDouble& x) {
  return Real(x.high) + Real(x.low);
}

/// A ball and the number it stands for.
template <class T>
struct Tracked {
  Ball<T> ball;
  Real truth;
};

template <class T>
::testing::AssertionResult Holds(const Tracked<T>& x) {
  if (!IsBounded(x.ball)) return ::testing::AssertionSuccess();
  if (Abs(ToReal(x.ball.value) - x.truth) <= Real(x.ball.error)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "value " << Leading(x.ball.value) << " error " << x.ball.error
         << " truth " << x.truth.ToDouble();
}

template <class T>
class BallTest : public ::testing::Test {};

using Types = ::testing::Types<double, DoubleDouble>;
TYPED_TEST_SUITE(BallTest, Types);

/// A start value: plain, tiny, huge, or a difference with cancellation.
template <class T>
Tracked<T> Start(PortableRandom& random, int spread) {
  const double a =
      std::ldexp(random.Uniform(-1, 1), random.Integer(-spread, spread));
  switch (random.Integer(0, 2)) {
    case 0:
      return {Ball<T>(a), Real(a)};
    case 1: {
      const double b = random.Nudge(a) + (random.OneIn(2) ? a * 0x1p-30 : 0);
      return {DifferenceOf<Ball<T>>::Of(a, b), Real(a) - Real(b)};
    }
    default: {
      const double b = random.Uniform(-1, 1);
      return {DifferenceOf<Ball<T>>::Of(a, b), Real(a) - Real(b)};
    }
  }
}

/// One operation on two members of the pool.
template <class T>
Tracked<T> Step(PortableRandom& random, const Tracked<T>& x,
                const Tracked<T>& y) {
  switch (random.Integer(0, 6)) {
    case 0:
      return {x.ball + y.ball, x.truth + y.truth};
    case 1:
      return {x.ball - y.ball, x.truth - y.truth};
    case 2:
    case 3:
      return {x.ball * y.ball, x.truth * y.truth};
    case 4:
      if (y.truth.ToDouble() == 0) return x;
      return {x.ball / y.ball, x.truth / y.truth};
    case 5: {
      if (x.truth < Real(0)) return {-x.ball, -x.truth};
      return {Sqrt(ClampToNonNegative(x.ball)), Sqrt(x.truth)};
    }
    default: {
      const Tracked<T> up{
          ClampToNonNegative(y.truth < Real(0) ? -y.ball : y.ball),
          Abs(y.truth)};
      if (random.OneIn(2)) {
        return {AngleInHalfPlane(up.ball, x.ball), Atan2(up.truth, x.truth)};
      }
      return {AngleInHalfPlane(x.ball, up.ball), Atan2(x.truth, up.truth)};
    }
  }
}

/// Runs chains; returns how many checked balls were bounded.
template <class T>
int RunChains(std::uint64_t seed, int spread) {
  PortableRandom random(seed);
  int bounded = 0;
  for (int chain = 0; chain < 4000; ++chain) {
    std::vector<Tracked<T>> pool;
    for (int i = 0; i < 4; ++i)
      pool.push_back(Start<T>(random, spread));
    for (int i = 0; i < 12; ++i) {
      const auto count = static_cast<int>(pool.size());
      const auto a = static_cast<std::size_t>(random.Integer(0, count - 1));
      const auto b = static_cast<std::size_t>(random.Integer(0, count - 1));
      pool.push_back(Step(random, pool[a], pool[b]));
      const auto holds = Holds(pool.back());
      EXPECT_TRUE(holds) << "chain " << chain << " step " << i;
      if (!holds) return bounded;
      if (IsBounded(pool.back().ball)) ++bounded;
    }
  }
  return bounded;
}

TYPED_TEST(BallTest, HoldsTheTruthAtOrdinarySizes) {
  EXPECT_GT(RunChains<TypeParam>(11, 20), 20000);
}

TYPED_TEST(BallTest, HoldsTheTruthWhereBinary64Underflows) {
  EXPECT_GT(RunChains<TypeParam>(12, 560), 10000);
}

TYPED_TEST(BallTest, HoldsTheTruthAtTheEndsOfTheRange) {
  EXPECT_GT(RunChains<TypeParam>(13, 1023), 5000);
}

// Soundness alone would be met by infinite bounds.
TYPED_TEST(BallTest, BoundIsCloseToTheError) {
  PortableRandom random(14);
  const double unit =
      std::is_same_v<TypeParam, double> ? kUnitRoundoff : kUnitSquared;
  for (int i = 0; i < 1000; ++i) {
    const Ball<TypeParam> x(random.Uniform(1, 2));
    const Ball<TypeParam> y(random.Uniform(1, 2));
    const Ball<TypeParam> z = Sqrt(x * x + y * y) / (x + y);
    EXPECT_LE(z.error, 60 * unit);
    EXPECT_LE(AngleInHalfPlane(x, y).error, 100 * unit);
  }
}

TYPED_TEST(BallTest, DivisorThatMayBeZeroIsUnbounded) {
  const Ball<TypeParam> one(1.0);
  const Ball<TypeParam> third = one / Ball<TypeParam>(3.0);
  const Ball<TypeParam> zero = third - third;
  EXPECT_FALSE(IsBounded(one / zero));
  EXPECT_FALSE(IsBounded(one / zero + one));
  EXPECT_FALSE(IsBounded((one / zero) * Ball<TypeParam>(0.0)));
}

TYPED_TEST(BallTest, OverflowIsUnboundedForEver) {
  const Ball<TypeParam> huge(0x1p1000);
  const Ball<TypeParam> overflown = huge * huge;
  EXPECT_FALSE(IsBounded(overflown));
  EXPECT_FALSE(IsBounded(overflown - overflown));
  EXPECT_FALSE(IsBounded(Ball<TypeParam>(1.0) / overflown));
  EXPECT_FALSE(IsBounded(
      DifferenceOf<Ball<TypeParam>>::Of(0x1.fffp1023, -0x1.fffp1023)));
}

TYPED_TEST(BallTest, AngleOfAnythingIsBoundedByPi) {
  const Ball<TypeParam> one(1.0);
  const Ball<TypeParam> third = one / Ball<TypeParam>(3.0);
  const Ball<TypeParam> zero = third - third;
  EXPECT_GE(AngleInHalfPlane(zero, zero).error, 3.14);
  EXPECT_LE(AngleInHalfPlane(zero, zero).error, 3.15);
}

TYPED_TEST(BallTest, ExactNumbersAreRoundedOnce) {
  PortableRandom random(16);
  for (int i = 0; i < 5000; ++i) {
    const double a = random.Uniform(-1, 1);
    const double b = random.Uniform(-1, 1);
    const double c = random.Uniform(-1, 1) * 0x1p-200;
    const Tracked<TypeParam> x{
        FromExact<Ball<TypeParam>>::Of(Exact(a) * Exact(b) + Exact(c)),
        Real(a) * Real(b) + Real(c)};
    EXPECT_TRUE(Holds(x));
    EXPECT_LE(x.ball.error, 1.1 * RoundingError<TypeParam>::kProduct *
                                    std::fabs(Leading(x.ball.value)) +
                                0x1p-490);
  }
}

}  // namespace
}  // namespace truelux::testing
