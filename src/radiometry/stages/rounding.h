// SPDX-License-Identifier: GPL-3.0-or-later
// From an enclosure of E to the binary64 nearest to E.

#ifndef TRUELUX_RADIOMETRY_STAGES_ROUNDING_H_
#define TRUELUX_RADIOMETRY_STAGES_ROUNDING_H_

#include <optional>

#include "exact/ball.h"
#include "radiometry/stages/multiprecision_stage.h"

namespace truelux {

/// The binary64 to which every number of the ball rounds (ties to even), if
/// there is just one.
std::optional<double> RoundIfCertain(const Ball<DoubleDouble>& x);

/// The same for an enclosure; +inf if it is too large for binary64.
std::optional<double> RoundIfCertain(const Enclosure& x);

/// For an enclosure that holds exactly one midpoint of two neighbouring
/// binary64 (the larger one may be +inf): the one with an even significand.
std::optional<double> RoundTieToEven(const Enclosure& x);

/// Half the distance from a correctly rounded result x >= 0 to its farther
/// neighbour, rounded up to a binary64; +inf for +inf.
double HalfSpacing(double x);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_ROUNDING_H_
