// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes a ray can meet, for the triangle tree.

#ifndef TRUELUX_SCENE_INDEX_RAY_BOXES_H_
#define TRUELUX_SCENE_INDEX_RAY_BOXES_H_

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "truelux/geometry.h"

#include "exact/filter.h"
#include "exact/lanes.h"
#include "scene/index/box.h"

namespace truelux {

/// The half-line of points origin + t direction, t >= 0, up to a t that may be
/// lowered; or all half-lines whose directions are within a bound. All members
/// require a RoundUpward object in the calling thread.
class RayBoxes {
 public:
  /// origin: finite. direction: its largest component in absolute value is
  /// within [2^-500, 2^500].
  RayBoxes(const Point3& origin, const Vector3& direction) {
    const std::array<double, 3> from{origin.x, origin.y, origin.z};
    const std::array<double, 3> along{direction.x, direction.y, direction.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = std::fabs(along[k]);
      if (along[k] == 0) {
        across_[across_count_++] = {from[k], from[k], k};
      } else if (size >= kLeast) {
        // -(1 / -size) is rounded downwards.
        slabs_[slab_count_++] = {from[k], 1 / size, -(1 / -size),
                                 along[k] > 0 ? k : k + 3,
                                 along[k] > 0 ? k + 3 : k};
      }
      // Any other component moves the ray too little to tell boxes apart.
    }
  }

  /// The rays of all directions whose components differ from the given ones by
  /// at most direction.error. end: none is asked for beyond this t. Requires that
  /// some component exceeds the error.
  RayBoxes(const Point3& origin, const ApproxVector& direction, double end)
      : end_(end) {
    const std::array<double, 3> from{origin.x, origin.y, origin.z};
    const std::array<double, 3> along{direction.x, direction.y, direction.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = std::fabs(along[k]);
      const double least = -(direction.error - size);
      const std::size_t near = along[k] > 0 ? k : k + 3;
      const std::size_t far = along[k] > 0 ? k + 3 : k;
      if (least >= kLeast) {
        slabs_[slab_count_++] = {from[k], 1 / least,
                                 -(1 / -(size + direction.error)), near, far};
        continue;
      }
      // It may turn either way, but not far before the end.
      const double width = (size + direction.error) * end;
      if (width < HUGE_VAL)
        across_[across_count_++] = {from[k] + width, -(width - from[k]), k};
    }
    assert(slab_count_ > 0);
  }

  /// From now on the ray ends at this parameter t.
  void EndAt(double parameter) { end_ = parameter; }

  /// Bit i is set unless box i is certainly apart from the ray.
  [[nodiscard]] unsigned Kept(const FourBoxes& boxes) const;

 private:
  static constexpr double kLeast = 0x1p-900;

  /// Two planes across an axis along which the ray moves.
  struct Slab {
    double origin;
    double most;       ///< at least 1 / |direction|
    double least;      ///< at most 1 / |direction|
    std::size_t near;  ///< row of FourBoxes that the ray comes to first
    std::size_t far;
  };

  /// An axis along which the ray stands still, or all but does.
  struct Across {
    double most;
    double least;
    std::size_t row;
  };

  std::array<Slab, 3> slabs_{};
  std::size_t slab_count_ = 0;
  std::array<Across, 3> across_{};
  std::size_t across_count_ = 0;
  double end_ = HUGE_VAL;
};

inline unsigned RayBoxes::Kept(const FourBoxes& boxes) const {
  // -entry and exit: bounds from above on -t and t where the ray enters and
  // leaves a box. x / |d| <= max(x * most, x * least), whatever the sign of x,
  // and every operation is rounded upwards.
  Lanes minus_entry{0, 0, 0, 0};
  Lanes exit{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  LaneFlags outside{0, 0, 0, 0};
  Lanes near;
  Lanes far;
  for (std::size_t i = 0; i < slab_count_; ++i) {
    const Slab& slab = slabs_[i];
    Load(boxes.rows[slab.near], near);
    Load(boxes.rows[slab.far], far);
    // Along a falling axis the near plane is the upper one.
    const bool rising = slab.near < slab.far;
    near = rising ? slab.origin - near : near - slab.origin;
    far = rising ? far - slab.origin : slab.origin - far;
    const Lanes near_most = near * slab.most;
    const Lanes near_least = near * slab.least;
    near = near_most > near_least ? near_most : near_least;
    minus_entry = near < minus_entry ? near : minus_entry;
    const Lanes far_most = far * slab.most;
    const Lanes far_least = far * slab.least;
    far = far_most > far_least ? far_most : far_least;
    exit = far < exit ? far : exit;
  }
  for (std::size_t i = 0; i < across_count_; ++i) {
    const Across& across = across_[i];
    Load(boxes.rows[across.row], near);
    Load(boxes.rows[across.row + 3], far);
    outside |= near > across.most;
    outside |= far < across.least;
  }
  outside |= exit < 0.0;
  outside |= exit + minus_entry < 0.0;
  outside |= end_ + minus_entry < 0.0;
  return ~Gather(outside) & ((1U << kLanes) - 1);
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_RAY_BOXES_H_
