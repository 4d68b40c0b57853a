// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles cut apart where E may jump.

#ifndef TRUELUX_ISOLUX_CUT_MESH_H_
#define TRUELUX_ISOLUX_CUT_MESH_H_

#include <span>
#include <vector>

#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// Triangles with points of their own on each side of a cut.
struct CutMesh {
  std::vector<PlanPoint> points;
  /// For each point: the one that it was before the cut.
  std::vector<int> origins;
  std::vector<PlanTriangle> triangles;
};

/// Gives a point of its own to each group of triangles that hang together around
/// a corner. points: shared by the triangles. triangles: with their neighbours,
/// and none where the mesh is cut.
CutMesh CutApart(std::span<const PlanPoint> points,
                 std::vector<PlanTriangle> triangles);

/// Moves the points on sides without a neighbour inwards, so that no receiver
/// lies on a face that stands there. margin: how far from the sides [length].
void MoveInwards(double margin, CutMesh& mesh);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_CUT_MESH_H_
