// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a planar ring of many points, or of one that meets itself, as
// triangles.

#ifndef TRUELUX_SCENE_RING_MESH_H_
#define TRUELUX_SCENE_RING_MESH_H_

#include <vector>

#include "scene/projected_ring.h"
#include "scene/ring_inside.h"
#include "scene/triangulation.h"

namespace truelux {

/// What a ring in one plane encloses, as FindInside says, and if that is kOnce
/// triangles of positive area whose union is its inside, and which have whole
/// edges in common or none: bridges are no edges of it. Exact. A ring that does
/// not meet itself is the plainest case.
///
/// Takes about n log n for n points, and the number of triangles that edges
/// cross in a triangulation of the points alone. triangles  cleared first.
RingInside MeshInside(const ProjectedRing& ring,
                      std::vector<RingTriangle>& triangles);

}  // namespace truelux

#endif  // TRUELUX_SCENE_RING_MESH_H_
