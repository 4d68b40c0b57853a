// SPDX-License-Identifier: GPL-3.0-or-later
// The first face along a ray, found exactly.

#ifndef TRUELUX_VISIBILITY_FIRST_HIT_H_
#define TRUELUX_VISIBILITY_FIRST_HIT_H_

#include <cstdint>
#include <optional>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "scene/index/triangle_tree.h"

namespace truelux {

/// The points origin + t direction, t > 0. Exact: its numbers are what they
/// are.
struct Ray {
  Point3 origin;      ///< finite
  Vector3 direction;  ///< largest component of size 2^-500 to 2^500
};

/// What a ray meets first.
struct FirstHit {
  int triangle = 0;         ///< index into Scene::triangles()
  bool from_front = false;  ///< whether the ray comes from the face's front
};

/// How the questions of FirstHitFinder were answered.
struct FirstHitCounts {
  std::uint64_t side_filter = 0;  ///< a ray against an edge or a plane
  std::uint64_t side_exact = 0;
  std::uint64_t order_filter = 0;  ///< which of two faces comes first
  std::uint64_t order_exact = 0;
};

/// Finds what rays meet in one scene. Triangles are closed, so that no ray
/// slips between two that share an edge or a corner. A triangle whose plane
/// contains the origin, or is parallel to the ray, is not met. Of triangles met
/// in the same point the one counts that would be seen if they lay in one plane
/// (scene/coplanar_order.h), of one facet the first triangle. Immutable; any
/// number of threads may use it.
class FirstHitFinder {
 public:
  explicit FirstHitFinder(const Scene& scene);

  /// Nothing if the ray meets no face. counts: if given, is added to.
  /// Throws std::invalid_argument if the ray is not as it must be.
  [[nodiscard]] std::optional<FirstHit> Find(
      const Ray& ray, FirstHitCounts* counts = nullptr) const;

  /// Where a ray meets the plane of a triangle. Each coordinate o + t d is
  /// within 0.54 ulp, so a value with few significant digits comes out exact.
  /// If the plane is perpendicular to an axis, that coordinate is the plane's
  /// own. If the rounded point is behind the plane as seen from the origin, one
  /// coordinate moves by an ulp or two until it is not: what is behind a face
  /// must not look over its edge. Requires that the ray meets the triangle
  /// (Find), and rounding to nearest.
  [[nodiscard]] Point3 PointOn(const Ray& ray, const FirstHit& hit) const;

 private:
  Scene scene_;
  TriangleTree tree_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_FIRST_HIT_H_
