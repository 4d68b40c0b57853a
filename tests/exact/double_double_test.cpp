// Every constant of double_double.h, held against MPFR.

#include "exact/double_double.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "exact/atan_table.h"
#include "exact/ball.h"
#include "support/portable_random.h"
#include "support/real.h"

namespace truelux::testing {
namespace {

ShortReal ToReal(const DoubleDouble& x) {
  return ShortReal(x.high) + ShortReal(x.low);
}

/// |computed - truth| / (|truth| unit).
double RelativeError(const ShortReal& computed, const ShortReal& truth,
                     double unit) {
  if (truth.ToDouble() == 0) return computed.ToDouble() == 0 ? 0 : HUGE_VAL;
  return (Abs(computed - truth) / (Abs(truth) * ShortReal(unit))).ToDouble();
}

/// Double-doubles with trouble in them: full and sparse mantissas, low parts
/// of exactly half an ulp, of zero, far below the high part.
class HardPairs {
 public:
  explicit HardPairs(std::uint64_t seed) : random_(seed) {}

  DoubleDouble Next(int max_exponent) {
    const int exponent = random_.Integer(-max_exponent, max_exponent);
    double high = std::ldexp(1 + Mantissa(), exponent);
    if (random_.OneIn(2)) high = -high;
    const double half_ulp =
        std::ldexp(1.0, std::ilogb(high) - 53) * (random_.OneIn(2) ? 1 : -1);
    double low = half_ulp * Mantissa();
    if (random_.OneIn(6)) low = 0;
    if (random_.OneIn(6)) low = half_ulp * (1 - 0x1p-53);
    if (random_.OneIn(8)) low *= 0x1p-40;
    return FastTwoSum(high, low);
  }

  /// A number whose sum with x cancels in most bits.
  DoubleDouble NextNear(const DoubleDouble& x) {
    DoubleDouble y =
        FastTwoSum(-random_.Nudge(x.high), x.low * random_.Uniform(-1.5, 1.5));
    if (random_.OneIn(4) && x.low != 0)
      y = FastTwoSum(-x.high, -random_.Nudge(x.low));
    return y;
  }

  PortableRandom& random() { return random_; }

 private:
  double Mantissa() {
    switch (random_.Integer(0, 4)) {
      case 0:
        return 0;
      case 1:
        return 1 - std::ldexp(1.0, random_.Integer(-52, -48));
      case 2:
        return std::ldexp(1.0, random_.Integer(-52, -1));
      default:
        return random_.Unit();
    }
  }

  PortableRandom random_;
};

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

TEST(DoubleDoubleAtan2, EveryTableEntryIsTheNearestPair) {
  for (int j = 0; j <= kAtanTableSteps; ++j) {
    const ShortReal truth = Atan2(ShortReal(j), ShortReal(kAtanTableSteps));
    const DoubleDouble& entry = kAtanTable[static_cast<std::size_t>(j)];
    EXPECT_EQ(entry.high, truth.ToDouble()) << j;
    EXPECT_EQ(entry.low, (truth - ShortReal(entry.high)).ToDouble()) << j;
  }
}

TEST(DoubleDoubleAtan2, StaysWithinItsProvenConstant) {
  HardPairs pairs(6);
  PortableRandom& random = pairs.random();
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    DoubleDouble x = pairs.Next(20);
    DoubleDouble y = pairs.Next(20);
    switch (i % 4) {
      case 0: {  // around a table entry's border, in every octant
        const double tangent = (random.Integer(0, 127) + 0.5) / 128;
        y = x * (tangent * (1 + random.Uniform(-1, 1) * 0x1p-40));
        if (random.OneIn(2)) std::swap(x, y);
        if (random.OneIn(2)) y = -y;
        break;
      }
      case 1:  // any angle
        y = x * random.Uniform(-3, 3);
        break;
      case 2:  // small angles, and angles near pi
        y = x * std::ldexp(random.Uniform(-1, 1), random.Integer(-60, 0));
        break;
      default:
        break;
    }
    worst = std::max(
        worst, RelativeError(ToReal(Atan2(y, x)), Atan2(ToReal(y), ToReal(x)),
                             kUnitSquared));
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, kAtan2Error);
  EXPECT_GT(worst, 1.0);
}

TEST(DoubleDoubleAtan2, HitsTheAxesAndDiagonals) {
  const DoubleDouble one{1, 0};
  const DoubleDouble zero{0, 0};
  EXPECT_EQ(Atan2(zero, one), zero);
  EXPECT_EQ(Atan2(zero, zero), zero);
  EXPECT_EQ(Atan2(one, zero).high, std::acos(-1) / 2);
  EXPECT_EQ(Atan2(zero, -one).high, std::acos(-1));
  EXPECT_EQ(Atan2(-one, zero).high, -std::acos(-1) / 2);
  EXPECT_EQ(Atan2(one, one).high, std::acos(-1) / 4);
  EXPECT_EQ(Atan2(one, -one).high, 3 * (std::acos(-1) / 4));
}

// The only fact about the C library that a bound relies on.
TEST(LibraryAtan2, IsWithinOneUlp) {
  PortableRandom random(7);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const int spread = i % 3 == 0 ? 1000 : 30;
    const double y =
        std::ldexp(random.Uniform(-1, 1), random.Integer(-spread, spread));
    const double x =
        std::ldexp(random.Uniform(-1, 1), random.Integer(-spread, spread));
    const double angle = std::atan2(y, x);
    if (std::fabs(angle) < 0x1p-1000) continue;
    const double ulp = std::ldexp(1.0, std::ilogb(angle) - 52);
    const ShortReal truth = Atan2(ShortReal(y), ShortReal(x));
    worst = std::max(
        worst, (Abs(ShortReal(angle) - truth) / ShortReal(ulp)).ToDouble());
  }
  RecordProperty("worst_ulp", std::to_string(worst));
  EXPECT_LE(worst, 1.0);
  EXPECT_GE(worst, 0.49);
}

TEST(LibraryAtan2, KeepsItsWordAtTheEndsOfTheRange) {
  for (const double y : {0x1p-1074, 0x1p-1022, 0x1p-500, 1.0, 0x1p1023}) {
    for (const double x : {0x1p-1074, 0x1p-1022, 0x1p-500, 1.0, 0x1p1023}) {
      for (const double sign : {1.0, -1.0}) {
        const double angle = std::atan2(y, sign * x);
        const ShortReal truth = Atan2(ShortReal(y), ShortReal(sign * x));
        const ShortReal error = Abs(ShortReal(angle) - truth);
        EXPECT_LE(error, Abs(truth) * ShortReal(RoundingError<double>::kAtan2) +
                             ShortReal(0x1p-1074))
            << y << " " << sign * x;
      }
    }
  }
}

}  // namespace
}  // namespace truelux::testing
