// SPDX-License-Identifier: GPL-3.0-or-later
// What can change the light on one side of a flat surface: lamps, and the edges
// of what stands before them.

#ifndef TRUELUX_ISOLUX_LIGHT_FEATURES_H_
#define TRUELUX_ISOLUX_LIGHT_FEATURES_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "exact/vec3.h"
#include "isolux/line_cover.h"
#include "isolux/plan_frame.h"
#include "surface/edge_planes.h"

namespace truelux {

/// A plane in the coordinates of a PlanFrame: height = normal . p - offset.
struct LightPlane {
  Vec3<double> normal;  ///< of length 1
  double offset = 0;

  [[nodiscard]] double HeightOf(const Vec3<double>& p) const {
    return Dot(normal, p) - offset;
  }

  [[nodiscard]] double HeightOf(const PlanPoint& p) const {
    return normal.x * p.s + normal.y * p.t - offset;
  }
};

/// A source that lights the surface: the part of an emitting facet above it.
struct Lamp {
  LightPlane plane;                ///< the front has positive heights
  std::vector<Vec3<double>> hull;  ///< corners; their hull holds the facet
  std::vector<std::array<Vec3<double>, 3>> triangles;
  double exitance = 0;  ///< M of the channel [W/m^2]
};

/// A convex piece of a face that stands over the surface.
struct Blocker {
  LightPlane plane;
  std::vector<Vec3<double>> corners;
};

/// The part of an edge above the surface.
struct LightEdge {
  std::array<Vec3<double>, 2> ends;
  int line = 0;  ///< as SceneEdge::line
  /// Where two facets meet, as seen from a receiver, on both sides of the edge,
  /// the edge bounds no shadow. That is so where the receiver is on one side of
  /// both planes. Else an edge may bound one from everywhere.
  bool has_two_facets = false;
  std::array<LightPlane, 2> planes{};
};

/// Everything in the coordinates of a frame.
class LightFeatures {
 public:
  /// weights: of the channels; a lamp's M is their sum. planes: EdgePlanesOf
  /// the scene and the surface.
  LightFeatures(const Scene& scene, const PlanFrame& frame,
                const EdgePlanes& planes, Emission emission,
                const Rgb& weights);

  [[nodiscard]] const std::vector<Lamp>& lamps() const { return lamps_; }

  [[nodiscard]] const std::vector<LightEdge>& edges() const { return edges_; }

  [[nodiscard]] const std::vector<Blocker>& blockers() const {
    return blockers_;
  }

  /// Whether two edges lie in one plane, exactly. Then they never seem to
  /// slide along each other.
  [[nodiscard]] bool AreCoplanar(const LightEdge& a, const LightEdge& b) const {
    return std::ranges::binary_search(
        coplanar_[static_cast<std::size_t>(a.line)], b.line);
  }

  /// The largest distance of anything from the origin [length]. Coordinates are
  /// off by a few 2^-53 of it.
  [[nodiscard]] double size() const { return size_; }

 private:
  void AddLamps(const Scene& scene, const PlanFrame& frame, Emission emission,
                const Rgb& weights);
  void AddEdges(const Scene& scene, const PlanFrame& frame,
                const EdgePlanes& planes);
  void AddEdge(const Scene& scene, const PlanFrame& frame,
               const LinePiece& piece, int line);
  void AddAboveSurface(LightEdge edge);
  void AddBlockers(const Scene& scene, const PlanFrame& frame);
  void FindCoplanarLines(const EdgePlanes& planes);

  std::vector<Lamp> lamps_;
  std::vector<LightEdge> edges_;
  std::vector<Blocker> blockers_;
  std::vector<std::vector<int>> coplanar_;  ///< lines, of each line; ascending
  double size_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LIGHT_FEATURES_H_
