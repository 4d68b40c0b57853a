// SPDX-License-Identifier: GPL-3.0-or-later
// What stands or hangs above a surface, for plans of it.

#ifndef TRUELUX_PLAN_PLAN_OBJECTS_H_
#define TRUELUX_PLAN_PLAN_OBJECTS_H_

#include <span>
#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/isolux.h"
#include "truelux/scene.h"

namespace truelux {

/// The faces of one group that emit, or those that do not.
struct PlanObject {
  std::string name;  ///< as in Scene::group_names(); empty: without a name
  bool emits = false;
  /// The corners of planar polygons; a face that is not planar is several. Their
  /// sense of rotation means nothing.
  std::vector<std::vector<Point3>> faces;
};

/// The objects above a surface, in the order of their first faces. A face is
/// among them if a part of it is above the plane of the surface, on the side to
/// which right x up of the Isolux points; it is there as a whole.
///
/// surface: the groups of the surface's faces, as indices into
/// Scene::group_names(). Without faces of these there are no objects.
[[nodiscard]] std::vector<PlanObject> PlanObjectsOf(
    const Scene& scene, std::span<const int> surface, const Isolux& isolux);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_OBJECTS_H_
