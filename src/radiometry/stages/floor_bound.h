// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of Method::kDouble that are little but the floor of balls.

#ifndef TRUELUX_RADIOMETRY_STAGES_FLOOR_BOUND_H_
#define TRUELUX_RADIOMETRY_STAGES_FLOOR_BOUND_H_

#include "truelux/irradiance.h"

#include "radiometry/evaluation_query.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// Replaces bounds that consist mostly of kUnderflow (exact/ball.h) by the
/// distance of the value from an enclosure of E in Arb's balls, which have no
/// floor. Values stay as they are.
///
/// Every operation of a ball adds 2^-500, and E in units of the channel's
/// largest emission takes fewer than 2^50 of them, each with a factor of at
/// most 2^8 on the way to E. A bound above 2^-440 of that emission is therefore
/// made of roundings, and stays [docs/errors.md section 2]. Below it are sources
/// whose form factors are smaller than about 2^-388, as of a square metre seen
/// from 1e59 m, which no running bound in balls can follow.
///
/// result: E of Method::kDouble with its bounds. evaluation: its emission; the
/// formula is of no importance. Requires at least one lit source.
void NarrowFloorBounds(const WeightedContour& contour,
                       const EvaluationQuery& evaluation, Irradiance& result);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_FLOOR_BOUND_H_
