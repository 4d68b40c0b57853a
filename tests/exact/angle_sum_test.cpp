// SPDX-License-Identifier: GPL-3.0-or-later
// Angles added by multiplying complex numbers, against arctangents of their
// own with 1400 bits: no turn is lost, and small angles keep their digits.

#include "exact/angle_sum.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

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

template <class T>
class AngleSumTest : public ::testing::Test {};

using Types = ::testing::Types<double, DoubleDouble>;
TYPED_TEST_SUITE(AngleSumTest, Types);

/// A sum and the true one.
template <class T>
struct Tracked {
  AngleSum<T> sum;
  Real truth;

  void Add(double y, double x, bool positive) {
    sum.Add(Ball<T>(y), Ball<T>(x), positive);
    const Real angle = Atan2(Real(y), Real(x));
    truth = positive ? truth + angle : truth - angle;
  }

  /// Whether the bound holds and is at most `limit`.
  [[nodiscard]] ::testing::AssertionResult Holds(double limit) const {
    const Ball<T> result = sum.Sum();
    if (!IsBounded(result)) return ::testing::AssertionFailure() << "unbounded";
    if (!(Abs(ToReal(result.value) - truth) <= Real(result.error))) {
      return ::testing::AssertionFailure()
             << Leading(result.value) << " +- " << result.error << ", is "
             << truth.ToDouble();
    }
    if (result.error > limit) {
      return ::testing::AssertionFailure() << "bound " << result.error;
    }
    return ::testing::AssertionSuccess();
  }
};

template <class T>
constexpr double kUnitOf = kUnitSquared;
template <>
constexpr double kUnitOf<double> = kUnitRoundoff;

TYPED_TEST(AngleSumTest, ManyAnglesOfAnySign) {
  PortableRandom random(71);
  double largest = 0;
  for (int i = 0; i < 3000; ++i) {
    Tracked<TypeParam> tracked;
    const int count = random.Integer(1, 40);
    // All of one sign in every second run: totals far beyond 2 pi.
    const bool mixed = i % 2 == 0;
    for (int k = 0; k < count; ++k) {
      const double length = std::ldexp(1.0, random.Integer(-40, 10));
      tracked.Add(length * random.Uniform(0, 1), length * random.Uniform(-1, 1),
                  mixed ? random.OneIn(2) : i % 4 == 1);
      ASSERT_TRUE(tracked.Holds(150 * (k + 1) * kUnitOf<TypeParam>)) << i;
      largest = std::max(largest, std::fabs(tracked.truth.ToDouble()));
    }
  }
  EXPECT_GT(largest, 40);
}

// Totals on the cut of the angle, on the axes and on the diagonals, and one
// rounding beside them; angles of 0 and of pi.
TYPED_TEST(AngleSumTest, AnglesThatMeetTheAxesAndDiagonals) {
  PortableRandom random(72);
  const std::vector<std::array<double, 2>> corners = {
      {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}};
  for (int i = 0; i < 4000; ++i) {
    Tracked<TypeParam> tracked;
    for (int k = 0; k < 12; ++k) {
      const auto& [y, x] =
          corners[static_cast<std::size_t>(random.Integer(0, 4))];
      const bool exact = random.OneIn(2);
      tracked.Add(exact ? y : std::fabs(y + random.Uniform(-1, 1) * 0x1p-52),
                  exact ? x : x + random.Uniform(-1, 1) * 0x1p-52,
                  i % 3 == 0 || random.OneIn(2));
      ASSERT_TRUE(tracked.Holds(150 * (k + 1) * kUnitOf<TypeParam>)) << i;
    }
  }
}

// Pieces of small angles: the bound is relative to the sum of magnitudes.
TYPED_TEST(AngleSumTest, SmallAnglesKeepTheirRelativeAccuracy) {
  PortableRandom random(73);
  for (int i = 0; i < 3000; ++i) {
    Tracked<TypeParam> tracked;
    const double size = std::ldexp(1.0, -random.Integer(0, 150));
    double sum = 0;
    for (int k = 0; k < 10; ++k) {
      const double y = size * random.Uniform(0, 1);
      tracked.Add(y, random.Uniform(1, 2), random.OneIn(2));
      sum += y;
      ASSERT_TRUE(
          tracked.Holds(100 * (k + 1) * kUnitOf<TypeParam> * sum + 0x1p-480))
          << i;
    }
  }
}

// Factors of 2^-150 or 2^150 over and over: the product is scaled.
TYPED_TEST(AngleSumTest, ManyFactorsNeitherUnderflowNorOverflow) {
  for (const int exponent : {-150, 150, 0}) {
    Tracked<TypeParam> tracked;
    for (int k = 0; k < 2000; ++k) {
      const double length = std::ldexp(1.0, exponent);
      tracked.Add(length * 0.3, length * 1.7, true);
    }
    EXPECT_TRUE(tracked.Holds(2e5 * kUnitOf<TypeParam>)) << exponent;
    EXPECT_GT(tracked.truth.ToDouble(), 300);
  }
}

// Each operand off by its whole error.
TYPED_TEST(AngleSumTest, ErrorsOfTheOperandsAreCounted) {
  using T = TypeParam;
  PortableRandom random(74);
  for (int i = 0; i < 5000; ++i) {
    AngleSum<T> sum;
    Real truth;
    const double error = std::ldexp(1.0, -random.Integer(25, 90));
    for (int k = 0; k < 8; ++k) {
      const double y = random.Uniform(0, 1);
      const double x = random.Uniform(-1, 1);
      const bool positive = random.OneIn(2);
      if (x * x + y * y < 0.01) continue;
      Ball<T> y_ball(y);
      Ball<T> x_ball(x);
      y_ball.error = x_ball.error = error;
      sum.Add(y_ball, x_ball, positive);
      const Real true_y = Abs(Real(y) + Real(random.OneIn(2) ? error : -error));
      const Real true_x = Real(x) + Real(random.OneIn(2) ? error : -error);
      const Real angle = Atan2(true_y, true_x);
      truth = positive ? truth + angle : truth - angle;
    }
    const Ball<T> result = sum.Sum();
    ASSERT_LE(Abs(ToReal(result.value) - truth), Real(result.error)) << i;
    ASSERT_LE(result.error, 400 * error + 1000 * kUnitOf<T>) << i;
  }
}

TYPED_TEST(AngleSumTest, WhatIsNotKnownIsUnbounded) {
  using T = TypeParam;
  for (const int place : {0, 1}) {
    AngleSum<T> sum;
    if (place == 1) sum.Add(Ball<T>(1.0), Ball<T>(1.0), true);
    Ball<T> wide(1.0);
    wide.error = 0x1p-19;
    sum.Add(Ball<T>(1.0), wide, true);
    sum.Add(Ball<T>(1.0), Ball<T>(1.0), true);
    EXPECT_FALSE(IsBounded(sum.Sum()));
  }
  AngleSum<T> nothing;
  nothing.Add(Ball<T>(0.0), Ball<T>(0.0), true);
  EXPECT_FALSE(IsBounded(nothing.Sum()));
  AngleSum<T> unbounded;
  unbounded.Add(Unbounded<T>(), Ball<T>(1.0), true);
  EXPECT_FALSE(IsBounded(unbounded.Sum()));
  EXPECT_EQ(Leading(AngleSum<T>().Sum().value), 0);
}

}  // namespace
}  // namespace truelux::testing
