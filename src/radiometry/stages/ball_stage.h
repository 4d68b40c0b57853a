// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance in double or double-double, with a proven bound.

#ifndef TRUELUX_RADIOMETRY_STAGES_BALL_STAGE_H_
#define TRUELUX_RADIOMETRY_STAGES_BALL_STAGE_H_

#include <array>
#include <vector>

#include "radiometry/evaluation_query.h"
#include "radiometry/stages/ball_geometry.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// E per channel as a ball; T = double or DoubleDouble. A channel that this
/// stage cannot bound is unbounded, the others are right all the same.
///
/// on_horizon: PlanesOnHorizon, used if SumsOverVertices(formula). geometry
/// is memory to work in.
template <class T>
std::array<Ball<T>, 3> EvaluateInBalls(const WeightedContour& contour,
                                       const EvaluationQuery& evaluation,
                                       const HorizonPlanes& on_horizon,
                                       BallGeometry<T>& geometry);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_BALL_STAGE_H_
