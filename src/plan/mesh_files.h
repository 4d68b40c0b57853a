// SPDX-License-Identifier: GPL-3.0-or-later
// Iso-meshes as files of other programs.

#ifndef TRUELUX_PLAN_MESH_FILES_H_
#define TRUELUX_PLAN_MESH_FILES_H_

#include <string>

#include "truelux/isomesh.h"

#include "plan/plan_subject.h"

namespace truelux {

/// OBJ: a texture coordinate (value, 0) a vertex, in W/m^2, since OBJ has no
/// numbers at vertices. Without materials.
[[nodiscard]] std::string MeshObj(const IsoMesh& mesh,
                                  const PlanSubject& subject);

/// PLY as text, in double, with the properties E (the value), E_r, E_g and E_b
/// [W/m^2].
[[nodiscard]] std::string MeshPly(const IsoMesh& mesh,
                                  const PlanSubject& subject);

/// VTK's XML for unstructured grids, as text: E (the value) and E_rgb at points
/// [W/m^2]; for triangles the face that is theirs, and what their three sides lie
/// on, from that of vertices 2 and 3 on: 0 nothing, 1 contour, 2 kink, 3 jump, 4
/// outline.
[[nodiscard]] std::string MeshVtu(const IsoMesh& mesh);

}  // namespace truelux

#endif  // TRUELUX_PLAN_MESH_FILES_H_
