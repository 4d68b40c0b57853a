// SPDX-License-Identifier: GPL-3.0-or-later
// What the image of a ring encloses that meets itself, by winding numbers.

#ifndef TRUELUX_SCENE_RING_INSIDE_H_
#define TRUELUX_SCENE_RING_INSIDE_H_

#include "scene/projected_ring.h"

namespace truelux {

/// The winding numbers of the points that do not lie on a ring.
enum class RingInside {
  kNothing,  ///< all 0
  kOnce,     ///< 1 in the inside, 0 elsewhere: the ring is a polygon
  kOther,    ///< some are neither 0 nor 1
};

/// Decides that, exactly, but for one case: where three edges or more cross in
/// one point that is no point of the ring, the numbers around it may be 0 and 1
/// in turn; that is kOther all the same, since the point would be a corner of
/// the inside, and binary64 need not have it. The answer does not depend on
/// where the ring begins.
///
/// Takes O(n^2) tests. Requires RoundUpward.
RingInside FindInside(const ProjectedRing& ring);

}  // namespace truelux

#endif  // TRUELUX_SCENE_RING_INSIDE_H_
