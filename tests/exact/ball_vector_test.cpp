// SPDX-License-Identifier: GPL-3.0-or-later
// A BallVector always holds the true vector: every operation against 1400
// bits, with operands that cancel, of mixed sizes and of mixed errors.

#include "exact/ball_vector.h"

#include <cmath>

#include <gtest/gtest.h>

#include "exact/ball_recipe.h"
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

using RealVector = std::array<Real, 3>;

Real RealLength(const RealVector& v) {
  return Sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

RealVector Minus(const RealVector& a, const RealVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Real DotOf(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RealVector CrossOf(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

/// A vector and what it stands for.
template <class T>
struct Tracked {
  BallVector<T> ball;
  RealVector truth;
};

template <class T>
RealVector ToRealVector(const Components<T>& v) {
  return {ToReal(v[0]), ToReal(v[1]), ToReal(v[2])};
}

/// |value - truth| / error, which may not exceed 1.
template <class T>
double Use(const Tracked<T>& x) {
  const Real distance = RealLength(Minus(ToRealVector(x.ball.value), x.truth));
  return (distance / Real(x.ball.error)).ToDouble();
}

template <class T>
double Use(const Ball<T>& x, const Real& truth) {
  return (Abs(ToReal(x.value) - truth) / Real(x.error)).ToDouble();
}

template <class T>
class BallVectorTest : public ::testing::Test {};

using Types = ::testing::Types<double, DoubleDouble>;
TYPED_TEST_SUITE(BallVectorTest, Types);

template <class T>
T Rounded(const Real& x) {
  if constexpr (std::is_same_v<T, double>) {
    return x.ToDouble();
  } else {
    const double high = x.ToDouble();
    return {high, (x - Real(high)).ToDouble()};
  }
}

/// A rounded vector of components of sizes within 2^+-spread: exact, or with
/// the truth anywhere in the ball.
template <class T>
Tracked<T> RandomVector(PortableRandom& random, int spread) {
  Tracked<T> v;
  for (std::size_t k = 0; k < 3; ++k) {
    const double high =
        std::ldexp(random.Uniform(-2, 2), -random.Integer(0, spread));
    const Real x = Real(high) + Real(high * random.Uniform(-1, 1) * 0x1p-53);
    v.ball.value[k] = Rounded<T>(random.OneIn(4) ? Real(high) : x);
  }
  v.truth = ToRealVector(v.ball.value);
  v.ball.length = LengthOf(v.ball.value);
  if (random.OneIn(2)) {
    // The whole ball is used up, in a random direction.
    v.ball.error = v.ball.length * std::ldexp(1.0, -random.Integer(20, 100));
    RealVector away{random.Uniform(-1, 1), random.Uniform(-1, 1),
                    random.Uniform(-1, 1)};
    const Real factor = Real(v.ball.error) / RealLength(away);
    for (std::size_t k = 0; k < 3; ++k)
      v.truth[k] = v.truth[k] + factor * away[k];
  }
  return v;
}

/// Nearly a multiple of v, with the same use of its ball.
template <class T>
Tracked<T> NearlyParallel(PortableRandom& random, const Tracked<T>& v) {
  Tracked<T> w = RandomVector<T>(random, 0);
  const Real factor = random.OneIn(2) ? -1 : 1;
  const Real tilt = std::ldexp(random.Uniform(-1, 1), -random.Integer(0, 110));
  for (std::size_t k = 0; k < 3; ++k) {
    w.ball.value[k] =
        Rounded<T>(factor * ToReal(v.ball.value[k]) + tilt * w.truth[k]);
  }
  w.truth = ToRealVector(w.ball.value);
  w.ball.length = LengthOf(w.ball.value);
  w.ball.error = 0;
  return w;
}

/// One perpendicular to v, nearly, so that the dot product cancels.
template <class T>
Tracked<T> NearlyPerpendicular(PortableRandom& random, const Tracked<T>& v) {
  Tracked<T> w = RandomVector<T>(random, 0);
  const RealVector cross = CrossOf(ToRealVector(v.ball.value), w.truth);
  for (std::size_t k = 0; k < 3; ++k)
    w.ball.value[k] = Rounded<T>(cross[k]);
  w.truth = ToRealVector(w.ball.value);
  w.ball.length = LengthOf(w.ball.value);
  w.ball.error = 0;
  return w;
}

TYPED_TEST(BallVectorTest, ProductsHoldTheTruth) {
  using T = TypeParam;
  PortableRandom random(61);
  double worst = 0;
  double worst_rounding = 0;
  for (int i = 0; i < 60000; ++i) {
    const Tracked<T> a = RandomVector<T>(random, i % 5 == 0 ? 120 : 3);
    const Tracked<T> b = i % 3 == 0   ? RandomVector<T>(random, 3)
                         : i % 3 == 1 ? NearlyParallel(random, a)
                                      : NearlyPerpendicular(random, a);
    const Tracked<T> cross{Cross(a.ball, b.ball), CrossOf(a.truth, b.truth)};
    const double use =
        std::max(Use(cross), Use(Dot(a.ball, b.ball), DotOf(a.truth, b.truth)));
    ASSERT_LE(use, 1) << i;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LE(Use(CrossComponent(a.ball, b.ball, k), cross.truth[k]), 1) << i;
    }
    ASSERT_LE(Use(Length(a.ball), RealLength(a.truth)), 1) << i;
    worst = std::max(worst, use);
    if (a.ball.error == 0 && b.ball.error == 0) {
      worst_rounding = std::max(worst_rounding, use);
    }
  }
  this->RecordProperty("worst_use", std::to_string(worst));
  this->RecordProperty("worst_use_of_exact", std::to_string(worst_rounding));
  EXPECT_GT(worst, 0.9);
  EXPECT_GT(worst_rounding, 0.2);
}

TYPED_TEST(BallVectorTest, DifferencesHoldTheTruth) {
  using T = TypeParam;
  PortableRandom random(62);
  for (int i = 0; i < 20000; ++i) {
    const int spread = i % 3 == 0 ? 900 : 20;
    const auto number = [&] {
      return std::ldexp(random.Uniform(-1, 1), random.Integer(-spread, spread));
    };
    const Point3 a{number(), number(), number()};
    const Point3 b{random.Nudge(a.x), number(), number()};
    const BallVector<T> difference = Difference<T>(a, b);
    const RealVector truth{Real(b.x) - Real(a.x), Real(b.y) - Real(a.y),
                           Real(b.z) - Real(a.z)};
    const Real distance =
        RealLength(Minus(ToRealVector(difference.value), truth));
    ASSERT_LE(distance, Real(difference.error)) << i;
    ASSERT_GE(difference.length * (1 + 0x1p-50),
              RealLength(ToRealVector(difference.value)).ToDouble());
  }
}

TYPED_TEST(BallVectorTest, LengthIsNeverBelowTheTruth) {
  PortableRandom random(63);
  for (int i = 0; i < 20000; ++i) {
    const int exponent = random.Integer(-1070, 1000);
    Components<TypeParam> v;
    for (TypeParam& x : v) {
      x = TypeParam{std::ldexp(random.Uniform(-1, 1), exponent)};
    }
    ASSERT_GE(LengthOf(v) * (1 + 0x1p-50),
              RealLength(ToRealVector(v)).ToDouble());
  }
}

TYPED_TEST(BallVectorTest, ScalingKeepsTheVector) {
  using T = TypeParam;
  PortableRandom random(15);
  for (int i = 0; i < 2000; ++i) {
    const int exponent = random.Integer(-990, 990);
    const auto number = [&] {
      return std::ldexp(random.Uniform(-1, 1), exponent);
    };
    const std::array<double, 3> plain{number(), number(), number()};
    ScaledVector<T> scaled;
    ASSERT_TRUE(ScaleToUnit(
        Components<T>{T{plain[0]}, T{plain[1]}, T{plain[2]}}, 0, scaled));
    const double size = SizeOf(scaled.vector.value);
    EXPECT_GE(size, 1);
    EXPECT_LT(size, 2);
    const ScaledVector<T> exact = ScaleToUnit<T>(
        Vec3<Exact>{Exact(plain[0]), Exact(plain[1]), Exact(plain[2])});
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(std::ldexp(Leading(scaled.vector.value[k]), scaled.exponent),
                plain[k]);
      EXPECT_EQ(std::ldexp(Leading(exact.vector.value[k]), exact.exponent),
                plain[k]);
    }
  }
}

TYPED_TEST(BallVectorTest, WhatOverflowsIsNotScaled) {
  using T = TypeParam;
  const double far = 0x1.fp1023;
  ScaledVector<T> scaled;
  for (const Point3& p : {Point3{-far, 0, 0}, {0, -far, 0}, {0, 0, -far}}) {
    const Point3 q{-p.x, -p.y, -p.z};
    const BallVector<T> difference = Difference<T>(p, q);
    EXPECT_FALSE(ScaleToUnit(difference.value, difference.error, scaled));
    const BallVector<T> other = Difference<T>({0, 0, 0}, {1, 2, 3});
    EXPECT_FALSE(ScaleToUnit(CrossValue(difference.value, other.value),
                             ErrorOfCross(difference, other), scaled));
  }
  EXPECT_FALSE(ScaleToUnit(Components<T>{}, 0, scaled));
}

}  // namespace
}  // namespace truelux::testing
