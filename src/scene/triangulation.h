// SPDX-License-Identifier: GPL-3.0-or-later
// A simple polygon as triangles.

#ifndef TRUELUX_SCENE_TRIANGULATION_H_
#define TRUELUX_SCENE_TRIANGULATION_H_

#include <array>
#include <vector>

#include "scene/projected_ring.h"

namespace truelux {

/// Three indices of points of a ring, counter-clockwise along its normal.
using RingTriangle = std::array<int, 3>;

/// Triangles of positive area whose union is the image of a simple ring: the
/// fan from point 0 if all its triangles have positive area, else what ear
/// clipping leaves that always removes the first ear in ring order. A triangle
/// (previous, tip, next) is an ear if its area is positive and no other point
/// lies in it or on its border.
///
/// triangles  cleared first. Takes O(n^2). Requires FindContact(ring) to find
/// nothing, and RoundUpward.
void Triangulate(const ProjectedRing& ring,
                 std::vector<RingTriangle>& triangles);

/// The same for a ring that meets itself and has inside kOnce (ring_inside.h):
/// a point that coincides with a corner of an ear does not block it, unless it
/// coincides with the tip and an edge goes from there between the ear's sides;
/// and spikes that are left are taken away. No triangles if nothing is an ear.
///
/// triangles  cleared first. Takes O(n^2), rarely O(n^3). Requires RoundUpward.
void TriangulateMeetingItself(const ProjectedRing& ring,
                              std::vector<RingTriangle>& triangles);

}  // namespace truelux

#endif  // TRUELUX_SCENE_TRIANGULATION_H_
