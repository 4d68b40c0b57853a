// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a planar ring of many points, as triangles.

#ifndef TRUELUX_SCENE_RING_MESH_H_
#define TRUELUX_SCENE_RING_MESH_H_

#include <optional>
#include <vector>

#include "scene/projected_ring.h"
#include "scene/ring_inside.h"
#include "scene/triangulation.h"

namespace truelux {

/// What a ring in one plane encloses, as FindInside says, and if that is kOnce
/// the triangles of its inside as TriangulateInside gives them. Exact. Nothing
/// if edges cross: FindInside has to decide. A ring that does not meet itself
/// is the plainest case.
///
/// Takes about n log n for n points, if edges are near few points that are not
/// theirs. triangles  cleared first.
std::optional<RingInside> MeshInside(const ProjectedRing& ring,
                                     std::vector<RingTriangle>& triangles);

}  // namespace truelux

#endif  // TRUELUX_SCENE_RING_MESH_H_
