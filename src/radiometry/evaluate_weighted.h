// SPDX-License-Identifier: GPL-3.0-or-later
// Visible contour -> irradiance, on an input that needs no scene.

#ifndef TRUELUX_RADIOMETRY_EVALUATE_WEIGHTED_H_
#define TRUELUX_RADIOMETRY_EVALUATE_WEIGHTED_H_

#include "truelux/irradiance.h"

#include "radiometry/evaluation_query.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

struct EvaluationWorkspace;

/// Whether a bound of Method::kDouble is so large beside its value that it is
/// worth choosing another formula for each source.
bool HasWideBound(const Irradiance& result);

/// evaluate.h, on an input that needs no scene. Of the workspace, `weights`
/// is not used.
Irradiance EvaluateWeighted(const WeightedContour& contour,
                            const EvaluationQuery& evaluation,
                            EvaluationWorkspace& workspace);

/// The same with a workspace of its own.
Irradiance EvaluateWeighted(const WeightedContour& contour,
                            const EvaluationQuery& evaluation);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_EVALUATE_WEIGHTED_H_
