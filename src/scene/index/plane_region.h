// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_SCENE_INDEX_PLANE_REGION_H_
#define TRUELUX_SCENE_INDEX_PLANE_REGION_H_

#include <array>
#include <cmath>
#include <cstddef>

#include "truelux/geometry.h"

#include "exact/filter.h"
#include "exact/lanes.h"
#include "scene/index/box.h"

namespace truelux {

/// The part of a plane that lies in a box. All members require a RoundUpward
/// object in the calling thread.
class PlaneRegion {
 public:
  /// point: of the plane.
  PlaneRegion(const FilteredPlane& normal, const Point3& point, const Box& box)
      : normal_{normal.v.x, normal.v.y, normal.v.z},
        error_(normal.v.error),
        point_{point.x, point.y, point.z},
        box_(box) {}

  /// Bit i is set unless box i is certainly apart from the region.
  [[nodiscard]] unsigned Kept(const FourBoxes& boxes) const {
    LaneFlags outside{0, 0, 0, 0};
    Lanes most{0, 0, 0, 0};         // at least N . (p - point), p in the box
    Lanes minus_least{0, 0, 0, 0};  // at least -N . (p - point)
    for (std::size_t k = 0; k < 3; ++k) {
      Lanes lo;
      Lanes hi;
      Load(boxes.rows[k], lo);
      Load(boxes.rows[k + 3], hi);
      outside |= (lo > box_.hi[k]) | (hi < box_.lo[k]);
      const Lanes above = hi - point_[k];  // at least p - point
      const Lanes below = point_[k] - lo;  // at least point - p
      const Lanes margin = (above > below ? above : below) * error_;
      const double n = std::fabs(normal_[k]);
      // n (p - point) <= n above, n (point - p) <= n below.
      most += (normal_[k] > 0 ? above : below) * n + margin;
      minus_least += (normal_[k] > 0 ? below : above) * n + margin;
    }
    // Written so that a NaN tells nothing.
    outside |= (most < 0.0) | (minus_least < 0.0);
    return ~Gather(outside) & ((1U << kLanes) - 1);
  }

 private:
  std::array<double, 3> normal_;
  double error_;
  std::array<double, 3> point_;
  Box box_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_PLANE_REGION_H_
