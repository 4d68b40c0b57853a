// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/exact_conversion.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Gmpq.h>

namespace truelux {

Exact TimesPowerOfTwo(const Exact& x, long exponent) {
  constexpr long kLargestStep = 1000;
  Exact result = x;
  while (exponent != 0) {
    const long step = std::clamp(exponent, -kLargestStep, kLargestStep);
    result = result * Exact(std::ldexp(1.0, static_cast<int>(step)));
    exponent -= step;
  }
  return result;
}

long BinaryExponentOf(const Exact& x) {
  return mpfr_get_exp(MultiprecisionOf(MPFR_PREC_MIN + 63, x).get());
}

mpq_class RationalOf(const Exact& x) {
  auto q = static_cast<mpq_class>(x);
  q.canonicalize();
  return q;
}

Multiprecision MultiprecisionOf(mpfr_prec_t precision, const Exact& x) {
  // The denominator of a dyadic number is 2^k: one rounding, no division.
  const CGAL::Gmpq quotient(x);
  const auto bits = mpz_sizeinbase(mpq_denref(quotient.mpq()), 2);
  Multiprecision result(precision);
  mpfr_set_z_2exp(result.get(), mpq_numref(quotient.mpq()),
                  1 - static_cast<mpfr_exp_t>(bits), MPFR_RNDN);
  return result;
}

}  // namespace truelux
