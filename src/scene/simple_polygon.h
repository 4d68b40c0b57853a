// SPDX-License-Identifier: GPL-3.0-or-later
// Does the boundary of a polygon meet itself?

#ifndef TRUELUX_SCENE_SIMPLE_POLYGON_H_
#define TRUELUX_SCENE_SIMPLE_POLYGON_H_

#include <optional>

#include "scene/projected_ring.h"

namespace truelux {

/// Two edges that have more in common than the vertex between neighbours.
/// Edge i runs from point i of the ring to the next.
struct BoundaryContact {
  int first_edge = 0;
  int second_edge = 0;
};

/// A contact of the ring's image with itself: a crossing, a pinch, a spike,
/// overlapping edges or points that coincide. Such a ring may be a polygon all
/// the same: ring_inside.h tells. A vertex of 180 degrees is
/// none. Takes O(n^2) box tests. Requires RoundUpward.
std::optional<BoundaryContact> FindContact(const ProjectedRing& ring);

}  // namespace truelux

#endif  // TRUELUX_SCENE_SIMPLE_POLYGON_H_
