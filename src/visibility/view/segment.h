// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of the scene as seen from r, and where a direction lies on one.

#ifndef TRUELUX_VISIBILITY_VIEW_SEGMENT_H_
#define TRUELUX_VISIBILITY_VIEW_SEGMENT_H_

#include <optional>

#include "base/ids.h"
#include "exact/number.h"
#include "exact/recipe.h"
#include "exact/vec3.h"
#include "visibility/view/seen_edge.h"

namespace truelux {

/// An edge of the scene, or a cut: the segment in which a triangle crosses the
/// plane of a facet.
struct Segment {
  DirectionRecipe from;
  DirectionRecipe to;
  VertexId a;  ///< the scene vertex at `from`, or none
  VertexId b;  ///< the scene vertex at `to`, or none
  SeenEdge edge;

  [[nodiscard]] bool IsCut() const { return edge.a < 0; }
};

/// A direction on the closed arc from one direction to another: a positive
/// multiple of it is weight_from * from + weight_to * to, both weights >= 0.
struct ArcPoint {
  Vec3<Exact> plane;  ///< from x to
  Exact weight_from;
  Exact weight_to;

  [[nodiscard]] bool IsFrom() const { return weight_to.is_zero(); }

  [[nodiscard]] bool IsTo() const { return weight_from.is_zero(); }
};

/// Where a direction d lies on the arc; nothing if it does not. Exact.
/// from and to are less than pi apart and not parallel.
std::optional<ArcPoint> PointOnArc(const Vec3<Exact>& from,
                                   const Vec3<Exact>& to, const Vec3<Exact>& d);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_SEGMENT_H_
