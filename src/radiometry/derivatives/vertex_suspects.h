// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices by which irradiance may have one-sided derivatives only.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_SUSPECTS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_SUSPECTS_H_

#include <set>

#include "radiometry/derivatives/coincident_lines.h"
#include "radiometry/derivatives/scene_contacts.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// Their numbers in the input: ends of edges that coincide as seen, also of
/// edges that are one in space but not by number; corners of faces seen
/// edge-on; of faces that overlap in the plane of a source or stand on it; and
/// around corners of 180 degrees [docs/derivatives.md, "Vertices"]. All others
/// have derivatives; some of these have, too.
///
/// contacts: of the engine's scene.
std::set<int> FindSuspects(const ContourEngine& engine,
                           const SceneContacts& contacts,
                           const ContourQuery& query, const SeenLines& seen);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_SUSPECTS_H_
