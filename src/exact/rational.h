// SPDX-License-Identifier: GPL-3.0-or-later
// Rational numbers where a quotient has to be exact, and the way back to
// binary64.

#ifndef TRUELUX_EXACT_RATIONAL_H_
#define TRUELUX_EXACT_RATIONAL_H_

#include <gmpxx.h>
#include <mpfr.h>

#include "truelux/geometry.h"

#include "exact/double_double.h"
#include "exact/multiprecision.h"
#include "exact/vec3.h"

namespace truelux {

using RationalVector = Vec3<mpq_class>;

inline RationalVector RationalOf(const Point3& p) {
  return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
}

/// The binary64 nearest to q, ties to even.
inline double NearestTo(const mpq_class& q) {
  // The first rounding is to odd, so that the second decides as if it were the
  // only one, for subnormal numbers, too.
  constexpr int kPrecision = 53 + 11;
  Multiprecision x(kPrecision);
  const int inexact = mpfr_set_q(x.get(), q.get_mpq_t(), MPFR_RNDZ);
  if (inexact == 0) return x.ToDouble();
  Multiprecision odd(kPrecision + 1);
  mpfr_set(odd.get(), x.get(), MPFR_RNDN);
  Multiprecision bit(kPrecision);
  mpfr_set_ui_2exp(bit.get(), 1, mpfr_get_exp(x.get()) - kPrecision - 1,
                   MPFR_RNDN);
  if (inexact < 0) {
    mpfr_add(odd.get(), odd.get(), bit.get(), MPFR_RNDN);
  } else {
    mpfr_sub(odd.get(), odd.get(), bit.get(), MPFR_RNDN);
  }
  return odd.ToDouble();
}

/// q within 2^-106 of itself, as long as nothing underflows; exact if its digits
/// fit. What is too large for binary64 is infinite.
inline DoubleDouble DoubleDoubleOf(const mpq_class& q) {
  const double high = NearestTo(q);
  if (!std::isfinite(high)) return {high, 0};
  return FastTwoSum(high, NearestTo(q - mpq_class(high)));
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_RATIONAL_H_
