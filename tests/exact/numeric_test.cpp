// SPDX-License-Identifier: GPL-3.0-or-later
// What closed formulas need of their number types: a Ball contains the true
// value for every real in its operands, the plain types are within a few units
// of it.

#include "exact/numeric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/real.h"

namespace truelux::testing {
namespace {

using B = Ball<double>;

/// Test points drawn per property.
constexpr int kDraws = 6000;

/// A ball and a real number in it.
struct Held {
  B ball;
  Real truth;
};

/// A ball around x of a random relative width, 0 in one case of four, and a
/// number in it, an end of it in two cases of three.
Held Around(PortableRandom& random, double x) {
  const double error =
      random.OneIn(4) ? 0
                      : std::ldexp(std::fabs(x) + (random.OneIn(8) ? 1 : 0),
                                   -random.Integer(0, 56));
  const double part = random.OneIn(3)   ? random.Uniform(-1, 1)
                      : random.OneIn(2) ? 1
                                        : -1;
  return {{x, error}, Real(x) + Real(part) * Real(error)};
}

/// Anything: usual, tiny, or near 0, 1 and -1.
double AnyNumber(PortableRandom& random) {
  switch (random.Integer(0, 4)) {
    case 0:
      return std::ldexp(random.Uniform(-1, 1), -random.Integer(0, 60));
    case 1:
      return (random.OneIn(2) ? 1 : -1) +
             std::ldexp(random.Uniform(-1, 1), -random.Integer(1, 56));
    case 2:
      return 0;
    default:
      return random.Uniform(-2, 2);
  }
}

::testing::AssertionResult Holds(const B& ball, const Real& truth) {
  if (!IsBounded(ball)) return ::testing::AssertionSuccess();
  if (Abs(Real(ball.value) - truth) <= Real(ball.error)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "value " << ball.value << " error " << ball.error << " off by "
         << Abs(Real(ball.value) - truth).ToDouble();
}

/// The arccosine of a number in [-1, 1].
Real TrueArcCosine(const Real& x) {
  return Atan2(Sqrt((Real(1) - x) * (Real(1) + x)), x);
}

Vec3<B> Balls(const Held& x, const Held& y, const Held& z) {
  return {x.ball, y.ball, z.ball};
}

// Balls -----------------------------------------------------------------------

TEST(NumericOfBall, LengthHoldsTheTruthEvenNearZero) {
  PortableRandom random(21);
  for (int i = 0; i < kDraws; ++i) {
    const double scale = std::ldexp(1.0, -random.Integer(0, 40) * (i % 3));
    const Held x = Around(random, scale * AnyNumber(random));
    const Held y = Around(random, scale * AnyNumber(random));
    const Held z = Around(random, scale * AnyNumber(random));
    const B length = Length(Balls(x, y, z));
    ASSERT_TRUE(IsBounded(length));
    ASSERT_GE(length.value, 0);
    ASSERT_TRUE(Holds(length, Sqrt(x.truth * x.truth + y.truth * y.truth +
                                   z.truth * z.truth)))
        << i;
  }
}

TEST(NumericOfBall, LengthIsBoundedWhereSquaresUnderflow) {
  const double tiny = 0x1p-600;
  const B length = Length(Vec3<B>{B(tiny), B(0.0), B(tiny)});
  EXPECT_TRUE(Holds(length, Sqrt(Real(2)) * Real(tiny)));
  EXPECT_LE(length.error, 0x1p-498);
  EXPECT_FALSE(IsBounded(Length(Vec3<B>{B(0x1p600), B(0.0), B(0.0)})));
}

TEST(NumericOfBall, LengthIsAsNarrowAsItsVector) {
  const Vec3<B> v = {{3, 1e-9}, {4, 2e-9}, B(0.0)};
  EXPECT_LE(Length(v).error, 3.01e-9);
}

TEST(NumericOfBall, FractionHoldsTheTruth) {
  PortableRandom random(22);
  int unknown = 0;
  for (int i = 0; i < kDraws; ++i) {
    Held x = Around(random, AnyNumber(random));
    Held y = Around(random, AnyNumber(random));
    // Whatever the balls hold, the truths are |x| <= y.
    if (y.truth < Real(0)) y = {-y.ball, -y.truth};
    if (y.truth < Abs(x.truth)) continue;
    if (y.truth <= Real(0)) continue;
    const B fraction = Fraction(x.ball, y.ball);
    ASSERT_TRUE(IsBounded(fraction));
    ASSERT_LE(fraction.error, 1);
    ASSERT_LE(std::fabs(fraction.value), 1);
    ASSERT_TRUE(Holds(fraction, x.truth / y.truth)) << i;
    if (fraction.error == 1) ++unknown;
  }
  EXPECT_GT(unknown, 50);
  EXPECT_LT(unknown, kDraws / 2);
}

TEST(NumericOfBall, FractionOfZerosIsZeroAndOfNothingKnownMinusOneToOne) {
  EXPECT_EQ(Fraction(B(0.0), B(0.0)).error, 0);
  for (const B& x :
       {B(0.0), B{1, 2}, Unbounded<double>(), B{std::nan(""), std::nan("")}}) {
    for (const B& y : {B{0, 1}, B{1, 1}, Unbounded<double>()}) {
      EXPECT_EQ(Fraction(x, y).value, 0);
      EXPECT_EQ(Fraction(x, y).error, 1);
    }
  }
}

TEST(NumericOfBall, ArcCosineHoldsTheTruth) {
  PortableRandom random(23);
  for (int i = 0; i < kDraws; ++i) {
    const Held x = Around(random, AnyNumber(random));
    if (Real(1) < Abs(x.truth)) continue;
    const B angle = ArcCosine(x.ball);
    ASSERT_TRUE(IsBounded(angle));
    ASSERT_TRUE(Holds(angle, TrueArcCosine(x.truth)))
        << i << " " << x.ball.value << " +- " << x.ball.error;
  }
}

// The ends of the ball are no doubles: rounded to nearest, they would move by
// half a unit in the last place, which is 1e-8 of the angle.
TEST(NumericOfBall, ArcCosineHoldsTheTruthAtTheVeryEndsNearOne) {
  PortableRandom random(24);
  for (int i = 0; i < kDraws; ++i) {
    const double sign = random.OneIn(2) ? 1 : -1;
    const double x = sign * (1 - random.Integer(0, 40) * 0x1p-53);
    const double error = random.Integer(1, 64) * 0x1p-58;
    for (const double end : {-error, error}) {
      const Real truth = Real(x) + Real(end);
      if (Real(1) < Abs(truth)) continue;
      ASSERT_TRUE(Holds(ArcCosine(B{x, error}), TrueArcCosine(truth)))
          << x << " +- " << error;
    }
  }
}

TEST(NumericOfBall, ArcCosineIsNarrow) {
  EXPECT_LE(ArcCosine(B(0.5)).error, 20 * kUnitRoundoff);
  EXPECT_EQ(ArcCosine(B(1.0)).value, 0);
  EXPECT_LE(ArcCosine(B(1.0)).error, 0x1p-400);
  EXPECT_LE(ArcCosine(B{0.5, 1e-9}).error, 1.16e-9);
  EXPECT_LE(ArcCosine(Unbounded<double>()).error, 3.1415926535897936);
}

TEST(NumericOfBall, AngleFromAxisHoldsTheTruth) {
  PortableRandom random(25);
  int bounded = 0;
  for (int i = 0; i < kDraws; ++i) {
    const Held x = Around(random, AnyNumber(random));
    const Held y = Around(random, AnyNumber(random));
    if (x.truth <= Real(0) && Real(0) <= x.truth && y.truth <= Real(0)) {
      continue;
    }
    Real truth = Atan2(y.truth, x.truth);
    if (truth < Real(0)) truth = truth + Real(2) * Real::Pi();
    const B angle = AngleFromAxis(y.ball, x.ball);
    if (IsBounded(angle)) ++bounded;
    ASSERT_TRUE(Holds(angle, truth))
        << y.ball.value << " +- " << y.ball.error << ", " << x.ball.value
        << " +- " << x.ball.error;
  }
  EXPECT_GT(bounded, kDraws / 2);
}

TEST(NumericOfBall, AngleFromAxisKnowsExactAxesAndNotNearlyThePositiveOne) {
  EXPECT_LE(AngleFromAxis(B(0.0), B(2.0)).value, 0);
  EXPECT_LE(AngleFromAxis(B(0.0), B(2.0)).error, 0x1p-400);
  EXPECT_LE(AngleFromAxis(B(-0.0), B(2.0)).error, 0x1p-400);
  for (const double zero : {0.0, -0.0}) {
    const B half_turn = AngleFromAxis(B(zero), B(-2.0));
    EXPECT_TRUE(Holds(half_turn, Real::Pi()));
    EXPECT_LE(half_turn.error, 1e-14);
  }
  const B near_negative = AngleFromAxis(B{0, 1e-9}, B(-1.0));
  EXPECT_TRUE(Holds(near_negative, Real::Pi()));
  EXPECT_LE(near_negative.error, 1e-8);
  EXPECT_FALSE(IsBounded(AngleFromAxis(B{0, 1e-9}, B(1.0))));
}

TEST(NumericOfBall, AngleHoldsTheTruthIfOneOperandIsNotNegative) {
  PortableRandom random(26);
  for (int i = 0; i < kDraws; ++i) {
    const Held x = Around(random, AnyNumber(random));
    const Held y = Around(random, AnyNumber(random));
    if (y.truth < Real(0) || (x.truth <= Real(0) && y.truth <= Real(0))) {
      continue;
    }
    const B upper = NonNegative(y.ball);
    ASSERT_TRUE(Holds(Angle(upper, x.ball), Atan2(y.truth, x.truth))) << i;
    ASSERT_TRUE(Holds(Angle(x.ball, upper), Atan2(x.truth, y.truth))) << i;
  }
}

TEST(NumericOfBall, RootOfWhatMayBeZeroIsBoundedOnlyWhereItHasASign) {
  EXPECT_TRUE(Holds(RootOfNonNegative(B{2, 1e-3}), Sqrt(Real(2.001))));
  EXPECT_TRUE(Holds(RootOfNonNegative(B{2, 1e-3}), Sqrt(Real(1.999))));
  EXPECT_EQ(RootOfNonNegative(B(0.0)).value, 0);
}

TEST(NumericOfBall, PiHoldsPi) {
  EXPECT_TRUE(Holds(Pi(B(1.0)), Real::Pi()));
  EXPECT_LE(Pi(B(1.0)).error, 4 * kUnitRoundoff);
}

TEST(NumericOfBall, SignsAreThoseOfAllItsNumbers) {
  EXPECT_TRUE(HasSign(B{1, 0.5}));
  EXPECT_TRUE(HasSign(B(0.0)));
  EXPECT_FALSE(HasSign(B{1, 1}));
  EXPECT_FALSE(HasSign(B{0, 0x1p-500}));
  EXPECT_FALSE(HasSign(B{std::nan(""), 0}));
  EXPECT_FALSE(HasSign(B{1, std::nan("")}));
  EXPECT_TRUE(IsZero(B(0.0)));
  EXPECT_FALSE(IsZero(B{0, 1}));
  EXPECT_TRUE(IsNegative(B{-1, 2}));
  EXPECT_FALSE(IsNegative(B{0, 2}));
}

TEST(NumericOfBall, WidenedAndUpperMagnitudeRoundUpwards) {
  PortableRandom random(27);
  for (int i = 0; i < kDraws; ++i) {
    const Held x = Around(random, AnyNumber(random));
    const double more = std::ldexp(random.Unit(), -random.Integer(0, 80));
    EXPECT_LE(Real(x.ball.error) + Real(more),
              Real(Widened(x.ball, more).error));
    EXPECT_EQ(Widened(x.ball, more).value, x.ball.value);
    EXPECT_LE(Abs(Real(x.ball.value)) + Real(x.ball.error),
              Real(UpperMagnitude(x.ball)));
  }
}

// Plain types -----------------------------------------------------------------

Real ToReal(float x) {
  return {x};
}

Real ToReal(double x) {
  return {x};
}

Real ToReal(const DoubleDouble& x) {
  return Real(x.high) + Real(x.low);
}

Real ToReal(const Multiprecision& x) {
  Real result;
  mpfr_set(result.get(), x.get(), MPFR_RNDN);
  return result;
}

constexpr mpfr_prec_t kPrecision = 300;

template <class T>
T Random(PortableRandom& random, double lo, double hi) {
  const double x = random.Uniform(lo, hi);
  if constexpr (std::is_same_v<T, Multiprecision>) {
    return Multiprecision(kPrecision, x) / Make<T>(3);
  } else if constexpr (std::is_same_v<T, DoubleDouble>) {
    return T{x, 0} / T{3, 0};
  } else {
    return static_cast<T>(x / 3);
  }
}

/// Half a unit in the last place of 1.
template <class T>
double Unit() {
  if (std::is_same_v<T, float>) return 0x1p-24;
  if (std::is_same_v<T, double>) return 0x1p-53;
  if (std::is_same_v<T, DoubleDouble>) return 0x1p-106;
  return std::ldexp(1.0, -static_cast<int>(kPrecision));
}

template <class T>
class NumericOf : public ::testing::Test {};

using Types = ::testing::Types<float, double, DoubleDouble, Multiprecision>;
TYPED_TEST_SUITE(NumericOf, Types);

TYPED_TEST(NumericOf, FunctionsAreWithinAFewUnits) {
  using T = TypeParam;
  PortableRandom random(31);
  const auto near = [](const T& x, const Real& truth, double units) {
    return Abs(ToReal(x) - truth) <= Real(units * Unit<T>()) * Abs(truth);
  };
  for (int i = 0; i < 500; ++i) {
    const T x = Random<T>(random, -3, 3);
    const T y = Random<T>(random, -3, 3);
    const T z = Random<T>(random, -3, 3);
    const Real rx = ToReal(x);
    const Real ry = ToReal(y);
    const Real rz = ToReal(z);
    const Real square = rx * rx + ry * ry + rz * rz;
    ASSERT_TRUE(near(Length(Vec3<T>{x, y, z}), Sqrt(square), 30));
    const Vec3<T> unit = Unit(Vec3<T>{x, y, z});
    ASSERT_TRUE(near(unit.y, ry / Sqrt(square), 50));
    ASSERT_TRUE(near(Angle(y, x), Atan2(ry, rx), 90));
    Real turn = Atan2(ry, rx);
    if (turn < Real(0)) turn = turn + Real(2) * Real::Pi();
    // Near 2 pi the bound is that of a sum.
    ASSERT_LE(Abs(ToReal(AngleFromAxis(y, x)) - turn), Real(600 * Unit<T>()));
    ASSERT_TRUE(near(RootOfNonNegative(x * x), Abs(rx), 10));
    if (Abs(rx) < Real(1)) {
      ASSERT_LE(Abs(ToReal(ArcCosine(x)) - TrueArcCosine(rx)),
                Real(300 * Unit<T>()));
    }
    ASSERT_EQ(IsNegative(x), rx < Real(0));
    ASSERT_EQ(IsZero(NonNegative(x)), rx < Real(0));
  }
}

TYPED_TEST(NumericOf, PiIsNearestAtThePrecisionOfItsOperand) {
  using T = TypeParam;
  PortableRandom random(32);
  const T like = Random<T>(random, 1, 2);
  EXPECT_LE(Abs(ToReal(Pi(like)) - Real::Pi()), Real(4 * Unit<T>()));
  // Also where the operand is an integer times such a number.
  EXPECT_LE(Abs(ToReal(Pi(Make<T>(2) * like)) - Real::Pi()),
            Real(4 * Unit<T>()));
}

TYPED_TEST(NumericOf, LimitsAreTheirValues) {
  using T = TypeParam;
  const T zero = Make<T>(0);
  EXPECT_TRUE(IsZero(Fraction(zero, zero)));
  EXPECT_TRUE(IsZero(RootOfNonNegative(Make<T>(-1))));
  EXPECT_TRUE(IsZero(RootOfNonNegative(zero)));
  EXPECT_TRUE(IsZero(Length(Vec3<T>{zero, zero, zero})));
  EXPECT_TRUE(IsZero(ArcCosine(Make<T>(1.5))));
  EXPECT_NEAR(Leading(ArcCosine(Make<T>(-1.5))), 3.14159265, 1e-6);
  EXPECT_NEAR(Leading(AngleFromAxis(Make<T>(-1), Make<T>(0))), 4.71238898,
              1e-6);
}

TYPED_TEST(NumericOf, NegligibleIsWhatDoesNotChangeASumByMoreThanItsLastBit) {
  using T = TypeParam;
  PortableRandom random(33);
  const T sum = Random<T>(random, 3, 6);
  T term = sum;
  int halvings = 0;
  for (; !IsNegligible(term, sum); ++halvings)
    term = term / Make<T>(2);
  EXPECT_LE(Abs(ToReal(sum + term) - ToReal(sum)),
            Real(2.1 * Unit<T>()) * ToReal(sum));
  EXPECT_NEAR(halvings, -std::log2(Unit<T>()), 2.1);
  EXPECT_TRUE(IsNegligible(Make<T>(0), sum));
}

// Atan2 looks up a table; without a check it would read anywhere.
TYPED_TEST(NumericOf, AngleOfWhatIsNotFiniteIsNoNumber) {
  using T = TypeParam;
  if constexpr (!std::is_same_v<T, Multiprecision>) {
    const auto make = [](double x) { return Make<T>(x); };
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), inf, -inf}) {
      EXPECT_TRUE(std::isnan(Leading(Angle(make(bad), make(bad)))) ||
                  (std::is_same_v<T, float>));
      EXPECT_FALSE(IsNegligible(make(std::nan("")), make(1)));
      (void)Angle(make(bad), make(1));
      (void)Angle(make(1), make(bad));
    }
  }
}

}  // namespace
}  // namespace truelux::testing
