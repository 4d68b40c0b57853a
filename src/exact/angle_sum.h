// SPDX-License-Identifier: GPL-3.0-or-later
// The sum of signed angles of one plane, with one arctangent for all of them.

#ifndef TRUELUX_EXACT_ANGLE_SUM_H_
#define TRUELUX_EXACT_ANGLE_SUM_H_

#include "exact/ball_vector.h"

namespace truelux {

/// pi/2; u or u^2 times the value bounds the error.
template <class T>
Ball<T> HalfPi();

template <>
inline Ball<double> HalfPi() {
  return {0x1.921fb54442d18p+0, 0x1p-53};
}

template <>
inline Ball<DoubleDouble> HalfPi() {
  return {{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}, 0x1p-105};
}

/// Adds angles of complex numbers by multiplying the numbers.
///
/// Each factor is first turned by quarter turns, exactly, to an angle of at
/// most pi/4, and so is each product; the quarter turns are counted. So two
/// angles that meet add up to pi/2 at most, and nothing ever comes near the
/// cut of the angle: no turn can be lost, however many there are and whatever
/// is rounded. What the factors are off and what a product is rounded are
/// bounded as angles, which add up; for small angles they are relative to the
/// sum of the angles' magnitudes. The proofs are docs/errors.md section 5.
///
/// A factor that is not known to 2^-20 of its size, or whose size is not in
/// [2^-200, 2^200], makes the sum unbounded.
template <class T>
class AngleSum {
 public:
  /// Adds the angle of (x, y), or subtracts it if not `positive`. y has been
  /// clamped: it is known not to be negative, and is not.
  void Add(const Ball<T>& y, const Ball<T>& x, bool positive) {
    // Turned back by a quarter turn, by half a turn, or not.
    const bool steep = Magnitude(y.value) > Magnitude(x.value);
    const bool left = !steep && Leading(x.value) < 0;
    const Ball<T>& from_real = steep ? y : x;
    const Ball<T>& from_imaginary = steep ? x : y;
    const T real = TimesSign(from_real.value, left ? -1 : 1);
    const T imaginary =
        TimesSign(from_imaginary.value, (steep || left) == positive ? -1 : 1);
    const double turns = steep ? 1 : left ? 2 : 0;
    quarter_turns_ += positive ? turns : -turns;

    const double size = Leading(real);
    const double side = Magnitude(imaginary);
    const double inverse = 1 / (size * size + side * side);
    error_ = RoundBoundUp(
        error_ + (size * from_imaginary.error + side * from_real.error) *
                     (inverse * (1 + 0x1p-17)));
    // Written so that a NaN is not known.
    const double narrow = 0x1p-20 * size;
    if (!(size >= 0x1p-200 && size <= 0x1p200 && from_real.error <= narrow &&
          from_imaginary.error <= narrow)) {
      error_ = std::numeric_limits<double>::infinity();
    }
    const double reach = size * side * inverse;
    if (empty_) {
      real_ = real;
      imaginary_ = imaginary;
      reach_ = reach;
      empty_ = false;
    } else {
      Multiply(real, imaginary, reach);
    }
  }

  /// The sum of the angles; 0 if none was added.
  [[nodiscard]] Ball<T> Sum() const {
    if (empty_) return Ball<T>(0.0);
    if (!std::isfinite(error_)) return Unbounded<T>();
    const T rest = Atan2(imaginary_, real_);
    const Ball<T> angle(rest, RoundBoundUp(error_ + RoundingError<T>::kAtan2 *
                                                        Magnitude(rest)));
    if (quarter_turns_ == 0) return angle;
    return Ball<T>(quarter_turns_) * HalfPi<T>() + angle;
  }

 private:
  /// Multiplies by a factor of an angle of at most pi/4, whose sine times
  /// cosine is `reach`.
  void Multiply(const T& real, const T& imaginary, double reach) {
    T next = SumOfProducts(real_, real, -imaginary_, imaginary);
    T across = SumOfProducts(real_, imaginary, imaginary_, real);
    reach_ += reach;
    // pi kDot2 (reach_ + reach) is an angle: docs/errors.md section 5.
    error_ = RoundBoundUp(error_ + 3.15 * RoundingError<T>::kDot2 * reach_);
    if (Magnitude(across) > Leading(next)) {
      const double sign = Leading(across) > 0 ? 1 : -1;
      const T old = next;
      next = TimesSign(across, sign);
      across = TimesSign(old, -sign);
      quarter_turns_ += sign;
    }
    const double size = Leading(next);
    if (size < 0x1p-100 || size > 0x1p100) {
      const double factor = PowerOfTwo(-ExponentOf(size));
      next = TimesPowerOfTwo(next, factor);
      across = TimesPowerOfTwo(across, factor);
    }
    real_ = next;
    imaginary_ = across;
    reach_ = std::min(reach_, 0.5);
  }

  // The product, |imaginary_| <= real_ up to a factor 1 + 2 u, is i to the
  // -quarter_turns_ of what it stands for.
  T real_{};
  T imaginary_{};
  /// The product's angle is at most pi/2 times this.
  double reach_ = 0;
  double error_ = 0;          ///< of the sum of the angles so far
  double quarter_turns_ = 0;  ///< a double holds any number of them
  bool empty_ = true;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_ANGLE_SUM_H_
