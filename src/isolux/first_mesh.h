// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of a surface between the lines at which light jumps.

#ifndef TRUELUX_ISOLUX_FIRST_MESH_H_
#define TRUELUX_ISOLUX_FIRST_MESH_H_

#include <span>
#include <vector>

#include "truelux/scene.h"

#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"
#include "surface/surface_frame.h"
#include "surface/surface_lines.h"

namespace truelux {

/// Distances along a surface that have to do with its size.
struct PlanScale {
  double size = 0;  ///< the longer side of the extent [length]
  /// How far outlines and jumps are kept away: 2^-36 of the size, and at least
  /// 2^-48 of the largest coordinate in the scene's frame. A receiver is rounded by
  /// less than a quarter of that, so that it stays on its side.
  double margin = 0;
};

/// A line at which triangles end, from corner to corner.
struct Seam {
  PlanPoint from;  ///< not moved
  PlanPoint to;
  SideKind kind = SideKind::kInner;
  int line = -1;  ///< of a kink or a jump: which of the lines
};

/// A mesh and its scale.
struct FirstMesh {
  PlanMesh mesh{{}, {}};
  PlanScale scale;
  std::vector<Seam> seams;  ///< PlanTriangle::seams are indices
  /// Triangles that were as thin as the margin and are left out.
  int left_out = 0;
};

/// A constrained Delaunay triangulation of the faces of one side, exact until
/// its points are rounded, with all lines as sides of triangles. Along jumps it
/// is cut apart. Points on outlines and on jumps are moved inwards by the margin,
/// so that no receiver lies on a face that stands there.
///
/// faces: FacesOfSide. lines: on these faces.
FirstMesh FirstMeshOf(const Scene& scene, const PlanFrame& plan,
                      std::span<const int> faces,
                      std::span<const ExactSurfaceLine> lines);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_FIRST_MESH_H_
