// SPDX-License-Identifier: GPL-3.0-or-later
// MPFR numbers as values.
//
// All functions round to nearest. Those that are given a destination take the
// precision of the result from it, operators from the operand that has more.
// Exponents: MPFR's default range, about 2^30 binary orders
// of magnitude, holds everything that recipes over binary64 can produce.

#ifndef TRUELUX_EXACT_MULTIPRECISION_H_
#define TRUELUX_EXACT_MULTIPRECISION_H_

#include <utility>

#include <mpfr.h>

namespace truelux {

/// Owns one mpfr_t of a fixed precision [bits]; starts as 0.
class Multiprecision {
 public:
  /// 0, to be assigned to.
  Multiprecision() : Multiprecision(MPFR_PREC_MIN) {}

  explicit Multiprecision(mpfr_prec_t precision);

  /// x rounded to nearest: relative error <= 2^-precision.
  Multiprecision(mpfr_prec_t precision, double x);

  Multiprecision(const Multiprecision& other);
  Multiprecision& operator=(const Multiprecision& other);

  Multiprecision(Multiprecision&& other) noexcept
      : Multiprecision(MPFR_PREC_MIN) {
    mpfr_swap(number_, other.number_);
  }

  Multiprecision& operator=(Multiprecision&& other) noexcept {
    mpfr_swap(number_, other.number_);
    return *this;
  }

  ~Multiprecision() { mpfr_clear(number_); }

  [[nodiscard]] mpfr_ptr get() { return number_; }

  [[nodiscard]] mpfr_srcptr get() const { return number_; }

  /// The nearest binary64, ties to even, rounded once (subnormals, too).
  [[nodiscard]] double ToDouble() const {
    return mpfr_get_d(number_, MPFR_RNDN);
  }

 private:
  mpfr_t number_{};
};

Multiprecision operator+(const Multiprecision& x, const Multiprecision& y);
Multiprecision operator-(const Multiprecision& x, const Multiprecision& y);
Multiprecision operator*(const Multiprecision& x, const Multiprecision& y);
Multiprecision operator/(const Multiprecision& x, const Multiprecision& y);
Multiprecision operator-(const Multiprecision& x);

/// The square root of x >= 0.
Multiprecision Sqrt(const Multiprecision& x);

/// The angle of (x, y) in [-pi, pi].
Multiprecision Angle(const Multiprecision& y, const Multiprecision& x);

Multiprecision PiOf(mpfr_prec_t precision);

}  // namespace truelux

#endif  // TRUELUX_EXACT_MULTIPRECISION_H_
