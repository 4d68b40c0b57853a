// SPDX-License-Identifier: GPL-3.0-or-later
// Every constant of double_double.h, held against MPFR.

#include "exact/double_double.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "exact/ball.h"
#include "exact/hard_pairs.h"

namespace truelux::testing {
namespace {

constexpr int kTrials = 100000;

TEST(DoubleDouble, SumAndDifferenceStayWithinTheirBound) {
  HardPairs pairs(1);
  double worst = 0;
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble x = pairs.Next(20);
    const DoubleDouble y = i % 2 == 0 ? pairs.Next(20) : pairs.NextNear(x);
    worst = std::max(
        {worst,
         RelativeError(ToReal(x + y), ToReal(x) + ToReal(y), kUnitSquared),
         RelativeError(ToReal(x - y), ToReal(x) - ToReal(y), kUnitSquared)});
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, RoundingError<DoubleDouble>::kSum / kUnitSquared);
  EXPECT_GT(worst, 1.0);
}

TEST(DoubleDouble, ProductStaysWithinItsBound) {
  HardPairs pairs(2);
  double worst = 0;
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble x = pairs.Next(60);
    const DoubleDouble y = pairs.Next(60);
    worst = std::max(worst, RelativeError(ToReal(x * y), ToReal(x) * ToReal(y),
                                          kUnitSquared));
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, RoundingError<DoubleDouble>::kProduct / kUnitSquared);
  EXPECT_GT(worst, 1.0);
}

TEST(DoubleDouble, OperationsWithOneDoubleStayWithinTheirBounds) {
  HardPairs pairs(3);
  double worst = 0;
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble x = pairs.Next(60);
    const double y = pairs.Next(60).high;
    worst = std::max(
        {worst,
         RelativeError(ToReal(x + y), ToReal(x) + ShortReal(y), kUnitSquared),
         RelativeError(ToReal(x * y), ToReal(x) * ShortReal(y), kUnitSquared)});
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, 2.0);
}

TEST(DoubleDouble, QuotientStaysWithinItsBound) {
  HardPairs pairs(4);
  double worst = 0;
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble x = pairs.Next(400);
    const DoubleDouble y = pairs.Next(400);
    worst = std::max(worst, RelativeError(ToReal(x / y), ToReal(x) / ToReal(y),
                                          kUnitSquared));
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, RoundingError<DoubleDouble>::kQuotient / kUnitSquared);
  EXPECT_GT(worst, 1.0);
}

TEST(DoubleDouble, RootStaysWithinItsBound) {
  HardPairs pairs(5);
  double worst = 0;
  for (int i = 0; i < kTrials; ++i) {
    DoubleDouble x = pairs.Next(800);
    if (x.high < 0) x = -x;
    worst = std::max(
        worst, RelativeError(ToReal(Sqrt(x)), Sqrt(ToReal(x)), kUnitSquared));
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, RoundingError<DoubleDouble>::kRoot / kUnitSquared);
  EXPECT_GT(worst, 0.5);
}

/// |computed - truth| in units of u^2 (u) times the sum of the magnitudes.
double ErrorOfSum(const ShortReal& computed, const ShortReal& truth,
                  const ShortReal& magnitudes, double unit) {
  if (magnitudes.ToDouble() == 0)
    return computed.ToDouble() == 0 ? 0 : HUGE_VAL;
  return (Abs(computed - truth) / (magnitudes * ShortReal(unit))).ToDouble();
}

// Products that cancel, to the last bit too, and products of any sizes.
TEST(DoubleDouble, SumsOfProductsStayWithinTheirBounds) {
  HardPairs pairs(8);
  PortableRandom& random = pairs.random();
  double worst2 = 0;
  double worst3 = 0;
  double worst_plain2 = 0;
  double worst_plain3 = 0;
  for (int i = 0; i < kTrials; ++i) {
    const int spread = i % 4 == 0 ? 60 : 1;
    DoubleDouble a = pairs.Next(spread);
    const DoubleDouble b = pairs.Next(spread);
    DoubleDouble c = pairs.Next(spread);
    DoubleDouble d = pairs.Next(spread);
    DoubleDouble e = pairs.Next(spread);
    const DoubleDouble f = pairs.Next(spread);
    if (i % 4 == 1) d = pairs.NextNear(a), c = b;  // a b + c d cancels
    if (i % 4 == 2) e = -(a * b + c * d) / f;      // all three cancel
    if (random.OneIn(20)) a = {a.high * 0x1p-53, a.low * 0x1p-53};
    const ShortReal ab = ToReal(a) * ToReal(b);
    const ShortReal cd = ToReal(c) * ToReal(d);
    const ShortReal ef = ToReal(e) * ToReal(f);
    const ShortReal magnitudes = Abs(ab) + Abs(cd);
    worst2 = std::max(worst2, ErrorOfSum(ToReal(SumOfProducts(a, b, c, d)),
                                         ab + cd, magnitudes, kUnitSquared));
    worst3 = std::max(
        worst3, ErrorOfSum(ToReal(SumOfProducts(a, b, c, d, e, f)),
                           ab + cd + ef, magnitudes + Abs(ef), kUnitSquared));
    const ShortReal high_ab = ShortReal(a.high) * ShortReal(b.high);
    const ShortReal high_cd = ShortReal(c.high) * ShortReal(d.high);
    const ShortReal high_ef = ShortReal(e.high) * ShortReal(f.high);
    const ShortReal high = Abs(high_ab) + Abs(high_cd);
    worst_plain2 = std::max(
        worst_plain2,
        ErrorOfSum(ShortReal(SumOfProducts(a.high, b.high, c.high, d.high)),
                   high_ab + high_cd, high, kUnitRoundoff));
    worst_plain3 =
        std::max(worst_plain3,
                 ErrorOfSum(ShortReal(SumOfProducts(a.high, b.high, c.high,
                                                    d.high, e.high, f.high)),
                            high_ab + high_cd + high_ef, high + Abs(high_ef),
                            kUnitRoundoff));
  }
  RecordProperty("worst_two_u2", std::to_string(worst2));
  RecordProperty("worst_three_u2", std::to_string(worst3));
  RecordProperty("worst_two_plain_u", std::to_string(worst_plain2));
  RecordProperty("worst_three_plain_u", std::to_string(worst_plain3));
  EXPECT_LE(worst2, RoundingError<DoubleDouble>::kDot2 / kUnitSquared);
  EXPECT_LE(worst3, RoundingError<DoubleDouble>::kDot3 / kUnitSquared);
  EXPECT_LE(worst_plain2, RoundingError<double>::kDot2 / kUnitRoundoff);
  EXPECT_LE(worst_plain3, RoundingError<double>::kDot3 / kUnitRoundoff);
  EXPECT_GT(worst2, 2.0);
  EXPECT_GT(worst3, 2.0);
  EXPECT_GT(worst_plain2, 0.9);
  EXPECT_GT(worst_plain3, 0.9);
}

// The sum of the high parts may be far smaller than the low part: the last
// addition must be exact all the same.
TEST(DoubleDouble, SumsOfProductsThatCancelAreExactWhenTheirPartsAre) {
  PortableRandom random(9);
  for (int i = 0; i < kTrials; ++i) {
    const double a = random.Uniform(1, 2);
    const double b = random.Uniform(1, 2);
    const DoubleDouble product = TwoProduct(a, b);
    const double nudged = random.Nudge(product.high);
    const DoubleDouble rest =
        SumOfProducts({a, 0}, {b, 0}, {-1, 0}, {nudged, 0});
    EXPECT_EQ(rest,
              FastTwoSum(product.high - nudged == 0 ? product.low
                                                    : product.high - nudged,
                         product.high - nudged == 0 ? 0 : product.low));
  }
}

}  // namespace
}  // namespace truelux::testing
