// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance in double by one formula, with a proven bound.

#ifndef TRUELUX_RADIOMETRY_NAMED_FORMULA_H_
#define TRUELUX_RADIOMETRY_NAMED_FORMULA_H_

#include <array>

#include "exact/ball.h"
#include "radiometry/evaluation_query.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// E per channel by evaluation.formula, in double; the bound holds what the
/// formula itself leaves out. kAuto takes for each source the smallest bound of
/// lambert-edge, difference, series and cubature. A channel with a source to
/// which the formula does not apply has a value that is NaN and no bound.
/// Requires a contour that is not joined.
std::array<Ball<double>, 3> EvaluateByFormula(
    const WeightedContour& contour, const EvaluationQuery& evaluation);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_NAMED_FORMULA_H_
