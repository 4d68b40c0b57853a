// SPDX-License-Identifier: GPL-3.0-or-later
// How a ring of points becomes triangles, or why it cannot.

#ifndef TRUELUX_SCENE_POLYGON_H_
#define TRUELUX_SCENE_POLYGON_H_

#include <span>
#include <vector>

#include "truelux/geometry.h"

#include "scene/projected_ring.h"
#include "scene/simple_polygon.h"
#include "scene/triangulation.h"

namespace truelux {

enum class PolygonKind {
  kNoArea,      ///< all points on one line
  kZeroNormal,  ///< not on one line, but the Newell normal is zero
  kNotSimple,   ///< the boundary meets itself, seen along the Newell normal
  kPlanar,      ///< a simple polygon in one plane
  kNotPlanar,   ///< simple as seen along the Newell normal
};

/// Takes rings one after the other and keeps its memory between them.
class PolygonReader {
 public:
  /// ring: n x 3, n >= 3, finite, no two consecutive points equal
  /// (cyclically). All decisions are exact (docs/scene_format.md, Faces).
  PolygonKind Read(std::span<const Point3> ring);

  /// Triangles of the last ring: of kPlanar their union is the polygon; of
  /// kNotPlanar they stand for it.
  [[nodiscard]] std::span<const RingTriangle> triangles() const {
    return triangles_;
  }

  /// Where the last ring, kNotSimple, meets itself.
  [[nodiscard]] const BoundaryContact& contact() const { return contact_; }

 private:
  ProjectedRing projection_;
  std::vector<RingTriangle> triangles_;
  BoundaryContact contact_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_POLYGON_H_
