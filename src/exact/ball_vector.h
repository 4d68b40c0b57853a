// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors with one running bound for all three components.
//
// BallVector<T>, T = double or DoubleDouble, stands for a real vector whose
// difference from the computed one is at most `error` long. A bound so costs a
// few operations a vector and not a few a component. As with Ball, what cannot
// be bounded has an error that is infinite or NaN. The proofs are
// docs/errors.md section 2.

#ifndef TRUELUX_EXACT_BALL_VECTOR_H_
#define TRUELUX_EXACT_BALL_VECTOR_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "truelux/geometry.h"

#include "exact/ball.h"

namespace truelux {

/// Components by index: which one is needed often depends on the data, and a
/// branch would be guessed wrong.
template <class T>
using Components = std::array<T, 3>;

template <class T>
struct BallVector {
  Components<T> value{};
  double length = 0;  ///< |value|, at least up to a factor 1 + 4 u
  double error = 0;   ///< at least |value - true vector|
};

/// |v| for BallVector::length; what is below 2^-450 counts as that, so that no
/// square that underflows is missed.
template <class T>
inline double LengthOf(const Components<T>& v) {
  const double x = Leading(v[0]);
  const double y = Leading(v[1]);
  const double z = Leading(v[2]);
  return std::sqrt(std::fma(x, x, std::fma(y, y, std::fma(z, z, 0x1p-900))));
}

/// Component k = 0, 1, 2 as a ball.
template <class T>
Ball<T> Component(const BallVector<T>& v, std::size_t k) {
  return {v.value[k], v.error};
}

/// b - a, whose error is known exactly. Components that overflow have errors
/// that are NaN.
inline void SetDifference(const Point3& a, const Point3& b,
                          Components<double>& value, double& error) {
  const DoubleDouble x = TwoSum(b.x, -a.x);
  const DoubleDouble y = TwoSum(b.y, -a.y);
  const DoubleDouble z = TwoSum(b.z, -a.z);
  value = {x.high, y.high, z.high};
  error = RoundBoundUp(std::fabs(x.low) + std::fabs(y.low) + std::fabs(z.low));
}

/// b - a, exactly. Components that overflow have low parts that are NaN.
inline void SetDifference(const Point3& a, const Point3& b,
                          Components<DoubleDouble>& value, double& error) {
  value = {TwoSum(b.x, -a.x), TwoSum(b.y, -a.y), TwoSum(b.z, -a.z)};
  error = 0;
}

/// b - a with its length.
template <class T>
BallVector<T> Difference(const Point3& a, const Point3& b) {
  BallVector<T> difference;
  SetDifference(a, b, difference.value, difference.error);
  difference.length = LengthOf(difference.value);
  return difference;
}

template <class T>
Components<T> Negated(const Components<T>& v) {
  return {-v[0], -v[1], -v[2]};
}

template <class T>
BallVector<T> operator-(const BallVector<T>& v) {
  return {Negated(v.value), v.length, v.error};
}

/// What the errors of a and b can change any bilinear product of both, a.b or
/// a x b: |a - a'| |b'| + |a| |b - b'|.
template <class T>
inline double ErrorOfOperands(const BallVector<T>& a, const BallVector<T>& b) {
  return a.error * (b.length + b.error) + a.length * b.error;
}

/// Component k of a x b, without its bound.
template <class T>
inline T CrossComponent(const Components<T>& a, const Components<T>& b,
                        std::size_t k) {
  const std::size_t i = k == 2 ? 0 : k + 1;
  const std::size_t j = k == 0 ? 2 : k - 1;
  return SumOfProducts(a[i], b[j], -a[j], b[i]);
}

/// a x b, without its bound.
template <class T>
inline Components<T> CrossValue(const Components<T>& a,
                                const Components<T>& b) {
  return {CrossComponent(a, b, 0), CrossComponent(a, b, 1),
          CrossComponent(a, b, 2)};
}

/// Bound on the error of CrossValue, and so of each component.
template <class T>
inline double ErrorOfCross(const BallVector<T>& a, const BallVector<T>& b) {
  return RoundBoundUp(ErrorOfOperands(a, b) +
                      RoundingError<T>::kCross * (a.length * b.length));
}

template <class T>
BallVector<T> Cross(const BallVector<T>& a, const BallVector<T>& b) {
  const Components<T> value = CrossValue(a.value, b.value);
  return {value, LengthOf(value), ErrorOfCross(a, b)};
}

/// Component k of a x b.
template <class T>
inline Ball<T> CrossComponent(const BallVector<T>& a, const BallVector<T>& b,
                              std::size_t k) {
  return {CrossComponent(a.value, b.value, k), ErrorOfCross(a, b)};
}

/// a.b, without its bound.
template <class T>
inline T DotValue(const Components<T>& a, const Components<T>& b) {
  return SumOfProducts(a[0], b[0], a[1], b[1], a[2], b[2]);
}

template <class T>
inline Ball<T> Dot(const BallVector<T>& a, const BallVector<T>& b) {
  return {DotValue(a.value, b.value),
          RoundBoundUp(ErrorOfOperands(a, b) +
                       RoundingError<T>::kDot3 * (a.length * b.length))};
}

/// |v|, of a size at which squares neither under- nor overflow. The root
/// halves the relative error of the sum of squares.
template <class T>
inline Ball<T> Length(const BallVector<T>& v) {
  return {Sqrt(DotValue(v.value, v.value)),
          RoundBoundUp(v.error +
                       (RoundingError<T>::kDot3 / 2 + RoundingError<T>::kRoot) *
                           v.length)};
}

/// The largest magnitude of a component. A NaN may be overlooked.
template <class T>
inline double SizeOf(const Components<T>& v) {
  return std::max({Magnitude(v[0]), Magnitude(v[1]), Magnitude(v[2])});
}

/// The index of a largest component.
template <class T>
std::size_t LargestComponent(const Components<T>& v) {
  const double x = Magnitude(v[0]);
  const double y = Magnitude(v[1]);
  const double z = Magnitude(v[2]);
  const std::size_t first = y > x ? 1 : 0;
  return z > std::max(x, y) ? 2 : first;
}

inline double Sum(double x) {
  return x;
}

/// NaN if either part is.
inline double Sum(const DoubleDouble& x) {
  return x.high + x.low;
}

inline double TimesPowerOfTwo(double x, double power_of_two) {
  return x * power_of_two;
}

inline DoubleDouble TimesPowerOfTwo(const DoubleDouble& x,
                                    double power_of_two) {
  return {x.high * power_of_two, x.low * power_of_two};
}

/// A vector known up to a positive factor, and the factor that was taken out:
/// what was meant is 2^exponent * vector; its largest component is in [1, 2)
/// (in [1/2, 2) where another precision was rounded).
template <class T>
struct ScaledVector {
  BallVector<T> vector;
  int exponent = 0;
};

/// The exponent of x, a normal number: 2^e <= |x| < 2^(e+1).
inline int ExponentOf(double x) {
  constexpr int kBias = 1023;
  constexpr std::uint64_t kField = 0x7ff;
  return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52) & kField) -
         kBias;
}

/// 2^exponent, for -1022 <= exponent <= 1023.
inline double PowerOfTwo(int exponent) {
  constexpr int kBias = 1023;
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kBias)
                               << 52);
}

/// Takes a power of two out of v, of which `error` bounds the error. False,
/// and nothing done, if a component overflowed or the largest is not in
/// [2^-1000, 2^1000).
template <class T>
[[nodiscard]] inline bool ScaleToUnit(const Components<T>& v, double error,
                                      ScaledVector<T>& scaled) {
  const double size = SizeOf(v);
  // With a size below 2^1000 the sum is finite unless a part is a NaN.
  const double probe = Sum(v[0]) + Sum(v[1]) + Sum(v[2]) + error;
  if (!(size >= 0x1p-1000 && size < 0x1p1000) || !std::isfinite(probe)) {
    return false;
  }
  const int exponent = ExponentOf(size);
  const double factor = PowerOfTwo(-exponent);
  const Components<T> value{TimesPowerOfTwo(v[0], factor),
                            TimesPowerOfTwo(v[1], factor),
                            TimesPowerOfTwo(v[2], factor)};
  scaled.vector.value = value;
  scaled.vector.length = LengthOf(value);
  scaled.vector.error = error * factor + kUnderflow;
  scaled.exponent = exponent;
  return true;
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_BALL_VECTOR_H_
