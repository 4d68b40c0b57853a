// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of one side of a surface.

#ifndef TRUELUX_ISOMESH_SIDE_MESH_H_
#define TRUELUX_ISOMESH_SIDE_MESH_H_

#include <cstddef>
#include <span>

#include "truelux/isomesh.h"

#include "isolux/contour_lines.h"
#include "isolux/prepared_surface.h"
#include "isomesh/edge_plan.h"
#include "isomesh/light_mesh.h"
#include "run/watch.h"

namespace truelux {

/// What a mesh is to be like.
struct MeshWishes {
  double error = 0;     ///< of interpolation, at most [W/m^2]
  double smallest = 0;  ///< triangles with shorter sides are not divided
  EdgeTolerances tolerances;
  std::size_t most_vertices = 0;
};

/// The mesh, with what was measured about it.
struct SideMesh {
  EdgePlan plan;
  LightMesh mesh;  ///< PlanTriangle::seams: indices into plan.edges
  std::size_t unfinished = 0;
  InterpolationError interpolation;
  InterpolationError uniform;
  std::size_t uniform_vertices = 0;
};

/// Throws Stopped.
SideMesh SideMeshOf(const Scene& scene, const SideSearch& side,
                    std::span<const ContourLine> contours,
                    const MeshWishes& wishes, int threads, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_SIDE_MESH_H_
