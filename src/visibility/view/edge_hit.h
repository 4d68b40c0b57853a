// SPDX-License-Identifier: GPL-3.0-or-later
// An edge that meets a direction.

#ifndef TRUELUX_VISIBILITY_VIEW_EDGE_HIT_H_
#define TRUELUX_VISIBILITY_VIEW_EDGE_HIT_H_

#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"
#include "visibility/view/seen_edge.h"

namespace truelux {

/// An edge, or the line where two faces meet, that passes through a direction
/// or ends there.
struct EdgeHit {
  Vec3<Exact> plane;  ///< normal of the edge's plane through r
  VertexId vertex;    ///< the scene vertex where it ends there, or none
  SeenEdge edge;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_EDGE_HIT_H_
