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
#include "surface/face_cuts.h"

namespace truelux {

/// An edge of an outline.
struct SceneEdge {
  std::array<int, 2> ends{};  ///< indices into Scene::vertices(), ascending
  int line = 0;               ///< the same for edges on one line of space
};

/// A segment in which an emitting face and another one pierce each other.
struct SceneCut {
  FaceCut ends;
  int line = 0;  ///< as SceneEdge::line
};

/// A plane that holds edges or cuts of at least two lines: normal . p = offset.
struct EdgePlane {
  PrimitiveVector normal;
  mpq_class offset;
  std::vector<int> lines;  ///< ascending
};

/// Planes with the edges and the cuts that make them.
struct EdgePlanes {
  std::vector<SceneEdge> edges;
  std::vector<SceneCut> cuts;
  std::vector<std::vector<int>> edges_of_line;  ///< indices into `edges`
  std::vector<std::vector<int>> cuts_of_line;   ///< indices into `cuts`
  std::vector<EdgePlane> planes;                ///< each once
  /// Whether all pairs of lines were looked at; else those of edges that meet
  /// in a vertex, and cuts were not looked for.
  bool is_complete = true;
};

/// With more lines, all pairs would take too long.
inline constexpr std::size_t kMostEdgeLines = 1024;

/// A kink of irradiance on a flat surface lies in one of these planes
/// [docs/derivatives.md, "Kinks"]: the planes of faces, and those of two lines
/// that meet, are parallel, or happen to be in one plane. Lines are those of
/// edges, and those where emitting faces are pierced: where others are, all is
/// dark. Everything is decided exactly.
///
/// surface: three corners in the plane of the surface. Edges and cuts that lie in
/// that plane are left out, since what is on a receiver's horizon has no weight.
/// most_lines: with more lines pairs are only looked for at vertices. stop: may be
/// null. Throws Stopped.
[[nodiscard]] EdgePlanes EdgePlanesOf(const Scene& scene,
                                      const std::array<Point3, 3>& surface,
                                      std::size_t most_lines = kMostEdgeLines,
                                      const StopFlag* stop = nullptr);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_EDGE_PLANES_H_
