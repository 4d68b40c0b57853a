// SPDX-License-Identifier: GPL-3.0-or-later
// atan2 in double and in double-double, with proven constants.
//
// Nothing of the C library is used, so that the results, and not only their
// bounds, are the same everywhere. The proofs are docs/errors.md section 4.

#ifndef TRUELUX_EXACT_ATAN2_H_
#define TRUELUX_EXACT_ATAN2_H_

#include "exact/double_double.h"

namespace truelux {

/// Relative error of Atan2 in double [u].
constexpr double kAtan2ErrorOfDouble = 5.2;

/// Relative error of Atan2 in double-double [u^2]. The proof is rough (the
/// largest measured is 11.9): what is summed with the angle is less sure.
constexpr double kAtan2Error = 80;

/// The angle of (x, y), in [-pi, pi] up to the error; 0 for (0, 0). Error <=
/// kAtan2ErrorOfDouble u (relative) + 2^-1070 (absolute) where max(|x|, |y|) is
/// 0 or in [2^-900, 2^900]. Requires finite x and y.
double Atan2(double y, double x);

/// The same in double-double. Error <= kAtan2Error u^2 (relative) + 2^-1060 (1
/// + 1 / max(|x|, |y|)) (absolute).
DoubleDouble Atan2(const DoubleDouble& y, const DoubleDouble& x);

}  // namespace truelux

#endif  // TRUELUX_EXACT_ATAN2_H_
