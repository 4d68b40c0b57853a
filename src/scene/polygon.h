// SPDX-License-Identifier: GPL-3.0-or-later
// How a ring of points becomes triangles, or why it cannot.

#ifndef TRUELUX_SCENE_POLYGON_H_
#define TRUELUX_SCENE_POLYGON_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/geometry.h"

#include "scene/projected_ring.h"
#include "scene/ring_inside.h"
#include "scene/simple_polygon.h"
#include "scene/triangulation.h"

namespace truelux {

/// The largest number of points of a ring that is not in one plane: its
/// triangles take time in proportion to the square.
inline constexpr std::size_t kMostNotPlanar = 10000;

enum class PolygonKind {
  kNoArea,     ///< no inside: all points on one line, or winding numbers 0
  kNoPolygon,  ///< planar, but some winding numbers are neither 0 nor 1
  kPlanar,     ///< a polygon in one plane
  kNotPlanar,  ///< not in one plane: stands for its triangles
  kTooLarge,   ///< not in one plane, with more points than kMostNotPlanar
};

/// Takes rings one after the other and keeps its memory between them.
class PolygonReader {
 public:
  /// ring: n x 3, n >= 3, finite, no two consecutive points equal
  /// (cyclically), no spikes. All decisions are exact (docs/scene_format.md,
  /// Faces).
  PolygonKind Read(std::span<const Point3> ring);

  /// The same for a polygon, n >= 4, of which some points are displaced. False,
  /// and no triangles, if it is none any more, or has too many points to be
  /// looked at one by one.
  bool ReadDisplaced(std::span<const Point3> ring,
                     const RingDisplacement& displacement);

  /// Triangles of the last ring: of kPlanar their union is the polygon; of
  /// kNotPlanar they stand for it.
  [[nodiscard]] std::span<const RingTriangle> triangles() const {
    return triangles_;
  }

  /// Where the last ring, kNoPolygon, meets itself.
  [[nodiscard]] const BoundaryContact& contact() const { return contact_; }

 private:
  PolygonKind ReadByMesh();
  PolygonKind ReadMeetingItself(RingShape shape);
  void TakeFan(std::span<const Point3> ring);

  ProjectedRing projection_;
  std::vector<RingTriangle> triangles_;
  BoundaryContact contact_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_POLYGON_H_
