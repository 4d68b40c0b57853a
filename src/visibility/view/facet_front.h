// SPDX-License-Identifier: GPL-3.0-or-later
// What lies in front of the plane of a facet: on the receiver's side of it.

#ifndef TRUELUX_VISIBILITY_VIEW_FACET_FRONT_H_
#define TRUELUX_VISIBILITY_VIEW_FACET_FRONT_H_

#include <optional>

#include "visibility/contour.h"
#include "visibility/view/segment.h"
#include "visibility/view/triangle_sides.h"

namespace truelux {

/// The half space between a facet's plane and the receiver r.
class FacetFront {
 public:
  /// The query's scene must outlive the object; r is not in the facet's plane.
  FacetFront(const ContourQuery& query, FacetId facet);

  [[nodiscard]] FacetId facet() const { return facet_; }

  /// Positive if a vertex is strictly in front, zero if it is on the plane.
  [[nodiscard]] Sign SideOf(VertexId vertex) const;

  /// Whether a point of a segment is strictly behind the plane. A cut is taken
  /// for one with this plane.
  [[nodiscard]] bool IsBehind(const Segment& segment,
                              const ArcPoint& point) const;

  /// Whether a triangle of another facet can hide some of this one: some of
  /// the triangle is strictly in front of the plane, or all of it is on the
  /// plane and is what is seen there (coplanar_order.h).
  [[nodiscard]] bool CanBeHiddenBy(TriangleId triangle) const;

  /// The segment in which a triangle of another facet crosses the plane;
  /// nothing if not both sides of the plane hold some of the triangle.
  [[nodiscard]] std::optional<Segment> CutOf(TriangleId triangle) const;

 private:
  const ContourQuery& query_;
  TriangleSides sides_;
  FacetId facet_;
  TriangleId
      triangle_;        ///< the first one of the facet; it stands for the plane
  Sign receiver_side_;  ///< the side of the plane, as OfVertex has it, of r
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_FACET_FRONT_H_
