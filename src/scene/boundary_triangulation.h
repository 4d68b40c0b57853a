// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a planar ring that meets itself, as triangles.

#ifndef TRUELUX_SCENE_BOUNDARY_TRIANGULATION_H_
#define TRUELUX_SCENE_BOUNDARY_TRIANGULATION_H_

#include <vector>

#include "scene/projected_ring.h"
#include "scene/ring_inside.h"
#include "scene/triangulation.h"

namespace truelux {

/// Triangles of positive area whose union is what a boundary encloses, and
/// which have whole edges in common or none: bridges are no edges of it.
///
/// ring: in one plane. boundary: as FindInside gives it.
/// triangles  cleared first.
void TriangulateInside(const ProjectedRing& ring,
                       const std::vector<BoundaryStep>& boundary,
                       std::vector<RingTriangle>& triangles);

}  // namespace truelux

#endif  // TRUELUX_SCENE_BOUNDARY_TRIANGULATION_H_
