// SPDX-License-Identifier: GPL-3.0-or-later
// From exact numbers to those of GMP and MPFR.

#ifndef TRUELUX_EXACT_EXACT_CONVERSION_H_
#define TRUELUX_EXACT_EXACT_CONVERSION_H_

#include <gmpxx.h>
#include <mpfr.h>

#include "exact/multiprecision.h"
#include "exact/number.h"

namespace truelux {

/// x * 2^exponent, without error and without a limit on the exponent.
[[nodiscard]] Exact TimesPowerOfTwo(const Exact& x, long exponent);

/// e with 2^(e-1) <= |x| < 2^e; x is not zero.
[[nodiscard]] long BinaryExponentOf(const Exact& x);

/// x itself.
[[nodiscard]] mpq_class RationalOf(const Exact& x);

/// x rounded to nearest: relative error <= 2^-precision.
[[nodiscard]] Multiprecision MultiprecisionOf(mpfr_prec_t precision,
                                              const Exact& x);

}  // namespace truelux

#endif  // TRUELUX_EXACT_EXACT_CONVERSION_H_
