// SPDX-License-Identifier: GPL-3.0-or-later
// The planes that two edges of a scene have in common.

#ifndef TRUELUX_SURFACE_EDGE_PLANES_H_
#define TRUELUX_SURFACE_EDGE_PLANES_H_

#include <array>
#include <cstddef>
#include <vector>

#include <gmpxx.h>

#include "truelux/geometry.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

#include "exact/primitive.h"

namespace truelux {

/// An edge of an outline.
struct SceneEdge {
  std::array<int, 2> ends{};  ///< indices into Scene::vertices(), ascending
  int line = 0;               ///< the same for edges on one line of space
};

/// A plane that holds edges of at least two lines: normal . p = offset.
struct EdgePlane {
  PrimitiveVector normal;
  mpq_class offset;
  std::vector<int> lines;  ///< ascending
};

/// Planes with the edges that make them.
struct EdgePlanes {
  std::vector<SceneEdge> edges;
  std::vector<std::vector<int>> edges_of_line;  ///< indices into `edges`
  std::vector<EdgePlane> planes;                ///< each once
  /// Whether all pairs of lines were looked at; else those of edges that meet
  /// in a vertex.
  bool is_complete = true;
};

/// With more lines, all pairs would take too long.
inline constexpr std::size_t kMostEdgeLines = 1024;

/// A kink of irradiance on a flat surface lies in one of these planes
/// [docs/derivatives.md, "Kinks"], if no faces pierce each other: the planes
/// of faces, and those of two edges that meet, are parallel, or happen to be in
/// one plane. Everything is decided exactly.
///
/// surface: three corners in the plane of the surface. Edges that lie in that
/// plane are left out, since what is on a receiver's horizon has no weight.
/// most_lines: with more lines pairs are only looked for at vertices. stop: may be
/// null. Throws Stopped.
[[nodiscard]] EdgePlanes EdgePlanesOf(const Scene& scene,
                                      const std::array<Point3, 3>& surface,
                                      std::size_t most_lines = kMostEdgeLines,
                                      const StopFlag* stop = nullptr);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_EDGE_PLANES_H_
