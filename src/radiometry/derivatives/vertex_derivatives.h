// SPDX-License-Identifier: GPL-3.0-or-later
// dE/dv of all vertices at one receiver.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_DERIVATIVES_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_DERIVATIVES_H_

#include <functional>

#include "truelux/derivatives.h"

#include "radiometry/derivatives/loose_engine.h"
#include "radiometry/derivatives/scene_contacts.h"
#include "radiometry/evaluation_query.h"
#include "radiometry/prepared_scene.h"
#include "visibility/contour.h"

namespace truelux {

/// E and its derivatives by vertices at query.receiver. Those of vertices that
/// may have none are limits: the contour is found with the vertex displaced to
/// either side (exact/displacement.h). loose: makes or has the scene for that;
/// only called if it is needed. contacts, workspace: of the engine.
VertexDerivatives VertexDerivativesAt(
    const ContourEngine& engine, const SceneContacts& contacts,
    const std::function<const LooseEngine&()>& loose, ContourQuery query,
    const EvaluationQuery& evaluation, OracleWorkspace& workspace);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_DERIVATIVES_H_
