// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_SCENE_COPLANAR_OVERLAP_H_
#define TRUELUX_SCENE_COPLANAR_OVERLAP_H_

#include <span>

#include "truelux/geometry.h"

namespace truelux {

/// Whether two polygons, each planar and strictly convex, lie in exactly one
/// plane, look to the same side and have more than a line in common. Requires a
/// RoundUpward object in the calling thread.
[[nodiscard]] bool OverlapInPlane(std::span<const Point3> a,
                                  std::span<const Point3> b);

/// Whether two such polygons in one plane look to the same side. Requires a
/// RoundUpward object in the calling thread.
[[nodiscard]] bool LookAlike(std::span<const Point3> a,
                             std::span<const Point3> b);

}  // namespace truelux

#endif  // TRUELUX_SCENE_COPLANAR_OVERLAP_H_
