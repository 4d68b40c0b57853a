// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that evaluations use again.

#ifndef TRUELUX_RADIOMETRY_EVALUATION_WORKSPACE_H_
#define TRUELUX_RADIOMETRY_EVALUATION_WORKSPACE_H_

#include <vector>

#include "truelux/geometry.h"

#include "radiometry/stages/ball_geometry.h"

namespace truelux {

/// One for each thread: with it, evaluations of contours of about the same
/// size allocate nothing. It carries no result from one to the next.
struct EvaluationWorkspace {
  std::vector<Rgb> weights;  ///< the emission of every source
  BallGeometry<double> plain;
  BallGeometry<DoubleDouble> double_double;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_EVALUATION_WORKSPACE_H_
