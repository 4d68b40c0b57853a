// SPDX-License-Identifier: GPL-3.0-or-later
// A number with a running bound on its absolute error.
//
// Ball<T>, T = double or DoubleDouble, stands for a real number x with
// |value - x| <= error. Every operation gives a ball that contains the result
// for every choice of reals in its operands, in round-to-nearest, also where
// binary64 underflows. What cannot be bounded (overflow, a divisor that may
// be 0) has an error that is infinite or NaN, and stays so: test IsBounded at
// the end, not in between. The proofs are docs/errors.md section 2.

#ifndef TRUELUX_EXACT_BALL_H_
#define TRUELUX_EXACT_BALL_H_

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/atan2.h"
#include "exact/double_double.h"

namespace truelux {

/// What one operation of T costs, relative to its result.
template <class T>
struct RoundingError;

/// Half an ulp for each rounding; kDot2 and kDot3 are relative to the sum of
/// the magnitudes of the products.
template <>
struct RoundingError<double> {
  static constexpr double kSum = kUnitRoundoff;
  static constexpr double kProduct = kUnitRoundoff;
  static constexpr double kQuotient = kUnitRoundoff;
  static constexpr double kRoot = kUnitRoundoff;
  static constexpr double kDot2 = 2.01 * kUnitRoundoff;
  static constexpr double kDot3 = 3.01 * kUnitRoundoff;
  static constexpr double kCross = 2.01 * kUnitRoundoff;
  static constexpr double kAtan2 = kAtan2ErrorOfDouble * kUnitRoundoff;
};

/// The constants of double_double.h, rounded up to cover their terms in u^3.
template <>
struct RoundingError<DoubleDouble> {
  static constexpr double kSum = 3.01 * kUnitSquared;
  static constexpr double kProduct = 5.01 * kUnitSquared;
  static constexpr double kQuotient = 11.01 * kUnitSquared;
  static constexpr double kRoot = 4.21 * kUnitSquared;
  static constexpr double kDot2 = 13.01 * kUnitSquared;
  static constexpr double kDot3 = 19.01 * kUnitSquared;
  static constexpr double kCross = 15.03 * kUnitSquared;
  static constexpr double kAtan2 = kAtan2Error * kUnitSquared;
};

/// Added to the error by every operation: far more than all underflows in the
/// value and in the bound itself can cost, each at most 2^-1075, and so large
/// that no product of two errors is subnormal, which would be slow
/// [docs/errors.md section 2]. Numbers that matter are scaled to about 1.
constexpr double kUnderflow = 0x1p-500;

/// A bound computed with up to 24 roundings, times this, is one again.
constexpr double kRoundUp = 1 + 0x1p-48;

inline double RoundBoundUp(double bound) {
  return bound * kRoundUp + kUnderflow;
}

/// |x| up to a factor 1 + u, which RoundBoundUp covers.
inline double Magnitude(double x) {
  return std::fabs(x);
}

inline double Magnitude(const DoubleDouble& x) {
  return std::fabs(x.high);
}

/// Not more than |x|.
inline double LowerMagnitude(double x) {
  return std::fabs(x);
}

inline double LowerMagnitude(const DoubleDouble& x) {
  return std::fabs(x.high) * (1 - 0x1p-52);
}

/// Leading part, correct in sign.
inline double Leading(double x) {
  return x;
}

inline double Leading(const DoubleDouble& x) {
  return x.high;
}

inline double Sqrt(double x) {
  return std::sqrt(x);
}

/// Where division, root and atan2 are free of intermediate under- and
/// overflow.
inline bool InSafeRange(double magnitude) {
  return magnitude >= 0x1p-900 && magnitude <= 0x1p900;
}

template <class T>
struct Ball {
  T value{};
  double error = 0;

  Ball() = default;

  explicit Ball(double x) : value{x} {}

  Ball(const T& v, double e) : value(v), error(e) {}
};

template <class T>
bool IsBounded(const Ball<T>& x) {
  return std::isfinite(Leading(x.value)) && std::isfinite(x.error);
}

template <class T>
Ball<T> Unbounded() {
  return {T{}, std::numeric_limits<double>::infinity()};
}

template <class T>
inline Ball<T> operator-(const Ball<T>& x) {
  return {-x.value, x.error};
}

template <class T>
inline Ball<T> operator+(const Ball<T>& x, const Ball<T>& y) {
  const T sum = x.value + y.value;
  return {sum, RoundBoundUp(x.error + y.error +
                            RoundingError<T>::kSum * Magnitude(sum))};
}

template <class T>
inline Ball<T> operator-(const Ball<T>& x, const Ball<T>& y) {
  return x + -y;
}

template <class T>
inline Ball<T> operator*(const Ball<T>& x, const Ball<T>& y) {
  const T product = x.value * y.value;
  return {product,
          RoundBoundUp(x.error * (Magnitude(y.value) + y.error) +
                       Magnitude(x.value) * y.error +
                       RoundingError<T>::kProduct * Magnitude(product))};
}

/// x / y; unbounded if y may be 0 or is out of the safe range.
template <class T>
inline Ball<T> operator/(const Ball<T>& x, const Ball<T>& y) {
  const double least = LowerMagnitude(y.value) - y.error;
  if (!(least > 0x1p-900) || !InSafeRange(Magnitude(y.value))) {
    return Unbounded<T>();
  }
  const T quotient = x.value / y.value;
  const double magnitude = Magnitude(quotient);
  return {quotient, RoundBoundUp((x.error + (magnitude + kUnderflow) * y.error +
                                  kUnderflow) /
                                     least +
                                 RoundingError<T>::kQuotient * magnitude)};
}

/// The same number, known not to be negative: 0 is then nearer than a negative
/// value. The result is never -0, which atan2 takes for the other side.
template <class T>
inline Ball<T> ClampToNonNegative(const Ball<T>& x) {
  return {Leading(x.value) > 0 ? x.value : T{}, x.error};
}

/// The square root of a number that is not negative. Unbounded below 2^-900,
/// where it would not be useful.
template <class T>
Ball<T> Sqrt(const Ball<T>& x) {
  if (!InSafeRange(Magnitude(x.value)) || Leading(x.value) < 0) {
    return Unbounded<T>();
  }
  // |sqrt a - sqrt b| = |a - b| / (sqrt a + sqrt b) <= |a - b| / sqrt a.
  const T root = Sqrt(x.value);
  const double magnitude = Magnitude(root);
  return {root, RoundBoundUp(x.error / magnitude +
                             RoundingError<T>::kRoot * magnitude)};
}

/// x times a power of two: exact but for underflow.
inline Ball<double> Scaled(const Ball<double>& x, double power_of_two) {
  return {x.value * power_of_two, x.error * power_of_two + kUnderflow};
}

inline Ball<DoubleDouble> Scaled(const Ball<DoubleDouble>& x,
                                 double power_of_two) {
  return {{x.value.high * power_of_two, x.value.low * power_of_two},
          x.error * power_of_two + kUnderflow};
}

/// x times 1 or -1, without a branch.
inline double TimesSign(double x, double sign) {
  return x * sign;
}

inline DoubleDouble TimesSign(const DoubleDouble& x, double sign) {
  return {x.high * sign, x.low * sign};
}

template <class T>
inline Ball<T> TimesSign(const Ball<T>& x, double sign) {
  return {TimesSign(x.value, sign), x.error};
}

/// The angle of (x, y) if it is known that y >= 0, or that x >= 0: the angle
/// then lies in a range of pi, and the error is at most pi whatever the balls
/// hold. The caller has clamped that operand.
///
/// Error  ((|x| + ex) ey + (|y| + ey) ex) / r^2 + kAtan2 |angle|, r the least
///        distance of the box from 0: the gradient of the angle is
///        (x dy - y dx) / (x^2 + y^2), and the segment from the computed to
///        the true point stays in the box, off 0 and off the cut.
template <class T>
Ball<T> AngleInHalfPlane(const Ball<T>& y, const Ball<T>& x) {
  // Not less than pi.
  constexpr double kWhole = 3.1415926535897936;
  const double x_size = Magnitude(x.value);
  const double y_size = Magnitude(y.value);
  // Neither Atan2 nor max() may meet a NaN.
  const bool bounded = IsBounded(x) && IsBounded(y);
  if (!bounded || !InSafeRange(std::max(x_size, y_size))) {
    return {T{}, kWhole};
  }
  const T angle = Atan2(y.value, x.value);
  const double x_least = std::max(0.0, LowerMagnitude(x.value) - x.error);
  const double y_least = std::max(0.0, LowerMagnitude(y.value) - y.error);
  const double square = x_least * x_least + y_least * y_least;
  double turn = kWhole;
  if (square >= 0x1p-900 && square <= 0x1p900) {
    turn = std::min(kWhole, ((x_size + x.error) * y.error +
                             (y_size + y.error) * x.error + kUnderflow) /
                                square);
  }
  return {angle,
          RoundBoundUp(turn + RoundingError<T>::kAtan2 * Magnitude(angle))};
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_BALL_H_
