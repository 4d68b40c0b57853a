// SPDX-License-Identifier: GPL-3.0-or-later
// All derivatives at one receiver.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_RECEIVER_DERIVATIVES_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_RECEIVER_DERIVATIVES_H_

#include "truelux/derivatives.h"

#include "radiometry/evaluation_query.h"
#include "radiometry/prepared_scene.h"
#include "visibility/contour.h"

namespace truelux {

/// E and its derivatives at query.receiver; E if it is wanted, by the sources'
/// whole contours. workspace: of the engine; what is told to its builder by
/// StartBlock is used.
Derivatives DerivativesAt(const ContourEngine& engine, ContourQuery query,
                          const EvaluationQuery& evaluation,
                          const DerivativeOptions& options,
                          bool wants_irradiance, OracleWorkspace& workspace);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_RECEIVER_DERIVATIVES_H_
