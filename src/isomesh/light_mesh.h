// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh with E at its vertices, to be interpolated in between.

#ifndef TRUELUX_ISOMESH_LIGHT_MESH_H_
#define TRUELUX_ISOMESH_LIGHT_MESH_H_

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"
#include "isomesh/refined_plane.h"
#include "run/watch.h"

namespace truelux {

/// A vertex of a mesh with light.
struct LightVertex {
  PlanPoint at;        ///< on the surface, also on outlines and jumps
  PlanPoint receiver;  ///< where E was asked for: beside them
  double value = 0;    ///< E there [W/m^2]
  int origin = 0;      ///< index into SharedMesh::points
};

/// Triangles with E at their corners. Vertices are doubled along jumps.
struct LightMesh {
  std::vector<LightVertex> vertices;
  std::vector<PlanTriangle> triangles;  ///< corners: indices into vertices

  /// E in a triangle by interpolation; weights: barycentric coordinates.
  [[nodiscard]] double ValueIn(const PlanTriangle& triangle,
                               const std::array<double, 3>& weights) const;

  [[nodiscard]] PlanPoint PointIn(const PlanTriangle& triangle,
                                  const std::array<double, 3>& weights) const;
};

/// E where it was asked for before.
using KnownValues = std::map<std::pair<double, double>, double>;

/// Puts light on a mesh. margin: how far from jumps and outlines E is asked for
/// [length]. tolerance: at the end of a jump E depends on the direction; each
/// triangle there gets a vertex of its own if its values differ by more [W/m^2].
/// known: is used and added to. Throws Stopped.
LightMesh LightMeshOf(const LightProbe& probe, const SharedMesh& mesh,
                      double margin, double tolerance, KnownValues& known,
                      int threads, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_LIGHT_MESH_H_
