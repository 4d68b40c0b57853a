// SPDX-License-Identifier: GPL-3.0-or-later
// What an arc adds to the gradient, in binary64: for explanations.

#ifndef TRUELUX_EXPLAIN_ARC_INTEGRAL_H_
#define TRUELUX_EXPLAIN_ARC_INTEGRAL_H_

#include "truelux/geometry.h"

namespace truelux {

/// The integral of w / rho over an arc, w the unit directions, rho the distance
/// of what the arc lies on; docs/derivatives.md (6). first, last: the
/// directions of its ends, of length 1; q1, q2: 1 / rho there; angle: of the
/// arc, in [0, pi) [rad]. The error is a few 1e-16 of |result|, and up to 1e-9
/// of it where the angle is below 1e-4.
[[nodiscard]] Vector3 InverseDistances(const Vector3& first,
                                       const Vector3& last, double q1,
                                       double q2, double angle);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_ARC_INTEGRAL_H_
