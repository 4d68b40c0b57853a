// SPDX-License-Identifier: GPL-3.0-or-later
// The two number types below the predicates, and the rounding they need.
//
// Exact     CGAL::Mpzf: dyadic numbers of any size; +, -, * and comparison
//           without error, any exponent range of binary64.
// Interval  CGAL::Interval_nt<false>: contains the true value as long as a
//           RoundUpward object lives in the calling thread.

#ifndef TRUELUX_EXACT_NUMBER_H_
#define TRUELUX_EXACT_NUMBER_H_

#include <optional>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include "exact/sign.h"

namespace truelux {

using Exact = CGAL::Mpzf;
using Interval = CGAL::Interval_nt<false>;

/// While it lives, double arithmetic of this thread rounds towards +infinity.
/// No libm function and no task scheduler may run in its scope.
using RoundUpward = CGAL::Protect_FPU_rounding<true>;

inline Sign SignOf(const Exact& x) {
  const CGAL::Sign s = x.sign();
  if (s == CGAL::NEGATIVE) return Sign::kNegative;
  return s == CGAL::POSITIVE ? Sign::kPositive : Sign::kZero;
}

/// The sign common to all numbers of the interval; nothing if there is none
/// (also for an interval with a NaN end).
inline std::optional<Sign> TrySign(const Interval& x) {
  if (x.inf() > 0) return Sign::kPositive;
  if (x.sup() < 0) return Sign::kNegative;
  if (x.inf() == 0 && x.sup() == 0) return Sign::kZero;
  return std::nullopt;
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_NUMBER_H_
