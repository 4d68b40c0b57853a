// SPDX-License-Identifier: GPL-3.0-or-later
// What a closed formula needs of its number type, for all five of them:
// float, double, DoubleDouble, Multiprecision (MPFR of any precision) and
// Ball<double> (double with a running bound).
//
// A formula is written once, with + - * / and these functions. For a Ball each
// function contains its result for every choice of reals in its operands, as
// the operations of exact/ball.h do.

#ifndef TRUELUX_EXACT_NUMERIC_H_
#define TRUELUX_EXACT_NUMERIC_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "exact/atan2.h"
#include "exact/ball.h"
#include "exact/double_double.h"
#include "exact/multiprecision.h"
#include "exact/vec3.h"

namespace truelux {

template <class T>
inline constexpr bool kIsBall = std::is_same_v<T, Ball<double>>;

/// x, which must be exact in T: small integers and their kind.
template <class T>
inline T Make(double x) {
  if constexpr (std::is_same_v<T, float>) {
    return static_cast<float>(x);
  } else if constexpr (std::is_same_v<T, Multiprecision>) {
    return Multiprecision(53, x);
  } else {
    return T{x};
  }
}

inline double Leading(float x) {
  return x;
}

inline double Leading(const Multiprecision& x) {
  return x.ToDouble();
}

inline double Leading(const Ball<double>& x) {
  return x.value;
}

template <class T>
inline bool IsNegative(const T& x) {
  return Leading(x) < 0;
}

inline bool IsNegative(const Multiprecision& x) {
  return mpfr_sgn(x.get()) < 0;
}

/// Whether x is exactly 0.
template <class T>
inline bool IsZero(const T& x) {
  return Leading(x) == 0;
}

inline bool IsZero(const Multiprecision& x) {
  return mpfr_zero_p(x.get()) != 0;
}

inline bool IsZero(const Ball<double>& x) {
  return x.value == 0 && x.error == 0;
}

/// Whether the sign of IsNegative is that of all reals in x. Numbers without a
/// bound are taken at their word.
template <class T>
inline bool HasSign(const T&) {
  return true;
}

inline bool HasSign(const Ball<double>& x) {
  // Written so that a NaN has none.
  return std::fabs(x.value) > x.error || IsZero(x);
}

inline float Sqrt(float x) {
  return std::sqrt(x);
}

/// The angle of (x, y) in [-pi, pi]; y or x must be known not to be negative
/// where T is a Ball.
inline float Angle(float y, float x) {
  return std::atan2(y, x);
}

inline double Angle(double y, double x) {
  // Atan2 looks up a table and may not meet what is not finite.
  if (!std::isfinite(y) || !std::isfinite(x)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return Atan2(y, x);
}

inline DoubleDouble Angle(const DoubleDouble& y, const DoubleDouble& x) {
  if (!std::isfinite(y.high) || !std::isfinite(x.high)) {
    return {std::numeric_limits<double>::quiet_NaN(), 0};
  }
  return Atan2(y, x);
}

inline Ball<double> Angle(const Ball<double>& y, const Ball<double>& x) {
  return AngleInHalfPlane(y, x);
}

/// pi, at the precision of `like`.
template <class T>
inline T Pi(const T& /*like*/) {
  if constexpr (kIsBall<T>) {
    return {std::numbers::pi, 0x1p-52};
  } else if constexpr (std::is_same_v<T, DoubleDouble>) {
    return {std::numbers::pi, 0x1.1a62633145c07p-53};
  } else {
    return static_cast<T>(std::numbers::pi);
  }
}

template <>
inline Multiprecision Pi(const Multiprecision& like) {
  return PiOf(mpfr_get_prec(like.get()));
}

/// x, known not to be negative: 0 if rounding has made it so.
template <class T>
inline T NonNegative(const T& x) {
  return IsNegative(x) ? Make<T>(0) : x;
}

inline Ball<double> NonNegative(const Ball<double>& x) {
  return ClampToNonNegative(x);
}

/// sqrt(x) of a number known not to be negative; 0 below.
template <class T>
inline T RootOfNonNegative(const T& x) {
  return IsNegative(x) || IsZero(x) ? Make<T>(0) : Sqrt(x);
}

/// Euclidean length. The Ball overload also accepts vectors that may be zero.
template <class T>
inline T Length(const Vec3<T>& v) {
  return RootOfNonNegative(Dot(v, v));
}

template <>
inline Ball<double> Length(const Vec3<Ball<double>>& v) {
  const double length = std::sqrt(
      v.x.value * v.x.value + v.y.value * v.y.value + v.z.value * v.z.value);
  // A sum of squares is off by 3 u relatively, its root by half that and u;
  // squares below 2^-1022 may be lost, which is at most 2^-510 in all.
  return {length, RoundBoundUp(v.x.error + v.y.error + v.z.error +
                               3 * kUnitRoundoff * length + 0x1p-500)};
}

template <class T>
inline Vec3<T> Unit(const Vec3<T>& v) {
  const T length = Length(v);
  return {v.x / length, v.y / length, v.z / length};
}

/// x / y where |x| <= y: 0 if y is 0. If the quotient of two Balls is too wide,
/// the result is the trivial enclosure [-1, 1].
template <class T>
inline T Fraction(const T& x, const T& y) {
  if (IsZero(y)) return Make<T>(0);
  return x / y;
}

template <>
inline Ball<double> Fraction(const Ball<double>& x, const Ball<double>& y) {
  if (IsZero(y)) return Ball<double>(0.0);
  const Ball<double> quotient = x / y;
  // Written so that a NaN is no bound.
  if (!(quotient.error < 1)) return {0, 1};
  return {std::clamp(quotient.value, -1.0, 1.0), quotient.error};
}

/// The angle in [0, pi] whose cosine is x; x a little beyond +-1 counts as
/// that. For a number without bound the error is that of a rounded cosine: up
/// to sqrt(2 u) near 0.
template <class T>
inline T ArcCosine(const T& x) {
  const T one = Make<T>(1);
  if (IsNegative(one - x)) return Make<T>(0);
  if (IsNegative(one + x)) return Pi(x);
  return Angle(RootOfNonNegative((one - x) * (one + x)), x);
}

/// x + y rounded upwards.
inline double SumUp(double x, double y) {
  const DoubleDouble sum = TwoSum(x, y);
  if (!(sum.low > 0)) return sum.high;
  return std::nextafter(sum.high, std::numeric_limits<double>::infinity());
}

template <>
inline Ball<double> ArcCosine(const Ball<double>& x) {
  if (!IsBounded(x)) return {0, 3.1415926535897936};
  // The arccosine falls, so its values at the ends enclose those in between.
  // The ends are rounded outwards: near +-1 half a unit in the last place is
  // 1e-8 of the angle. ArcCosine in double is off by 7.7 u relatively: u for
  // each factor and their product, halved by the root, u for that, and 5.2 u.
  const double middle = std::clamp(x.value, -1.0, 1.0);
  const double angle = ArcCosine(middle);
  const double least = ArcCosine(std::min(1.0, SumUp(middle, x.error)));
  const double most = ArcCosine(std::max(-1.0, -SumUp(-middle, x.error)));
  return {angle, RoundBoundUp(std::max(angle - least, most - angle) +
                              8 * kUnitRoundoff * most)};
}

/// The angle of (x, y) in [0, 2 pi). Of a Ball unbounded if it may be either
/// side of the positive x axis.
template <class T>
inline T AngleFromAxis(const T& y, const T& x) {
  const T angle = Angle(y, x);
  return IsNegative(angle) ? angle + Make<T>(2) * Pi(angle) : angle;
}

template <>
inline Ball<double> AngleFromAxis(const Ball<double>& y,
                                  const Ball<double>& x) {
  using B = Ball<double>;
  const B pi = Pi(x);
  if (HasSign(y)) {
    // Clamped, as Atan2 takes -0 for the other side.
    if (!IsNegative(y)) return Angle(ClampToNonNegative(y), x);
    return B(2.0) * pi - Angle(-y, x);
  }
  // Turned by a quarter to (y, -x).
  if (HasSign(x) && IsNegative(x)) return B(0.5) * pi + Angle(-x, y);
  return Unbounded<double>();
}

/// At least |x|, but for a number without a bound |x| in double.
template <class T>
inline double UpperMagnitude(const T& x) {
  return std::fabs(Leading(x));
}

inline double UpperMagnitude(const Ball<double>& x) {
  return RoundBoundUp(std::fabs(x.value) + x.error);
}

/// Whether adding x to `sum` changes nothing but its last bit at most.
template <class T>
inline bool IsNegligible(const T& x, const T& sum) {
  constexpr double kLast = std::is_same_v<T, float>          ? 0x1p-25
                           : std::is_same_v<T, DoubleDouble> ? 0x1p-108
                                                             : 0x1p-54;
  return std::fabs(Leading(x)) <= kLast * std::fabs(Leading(sum));
}

inline bool IsNegligible(const Multiprecision& x, const Multiprecision& sum) {
  return IsZero(x) || mpfr_get_exp(x.get()) <
                          mpfr_get_exp(sum.get()) - mpfr_get_prec(sum.get());
}

/// x with its bound made larger by `error`; only a Ball has one.
template <class T>
inline T Widened(const T& x, double /*error*/) {
  return x;
}

inline Ball<double> Widened(const Ball<double>& x, double error) {
  return {x.value, RoundBoundUp(x.error + error)};
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_NUMERIC_H_
