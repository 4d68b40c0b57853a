// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes meet a given one, for the triangle tree.

#ifndef TRUELUX_SCENE_INDEX_BOX_OVERLAP_H_
#define TRUELUX_SCENE_INDEX_BOX_OVERLAP_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "truelux/geometry.h"

#include "exact/lanes.h"
#include "scene/index/box.h"

namespace truelux {

/// The region of a closed box.
class BoxOverlap {
 public:
  explicit BoxOverlap(const Box& box) : box_(box) {}

  /// A cube that holds all points whose coordinates differ from a centre's by
  /// at most `half`. centre: finite. half >= 0, perhaps infinite. Requires a
  /// RoundUpward object in the calling thread.
  static BoxOverlap Around(const Point3& centre, double half) {
    // Finite, so that empty boxes, which are infinitely far away, stay outside.
    constexpr double kMost = std::numeric_limits<double>::max();
    const std::array<double, 3> at{centre.x, centre.y, centre.z};
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.hi[k] = std::min(at[k] + half, kMost);
      box.lo[k] = std::max(-(half - at[k]), -kMost);  // rounded downwards
    }
    return BoxOverlap(box);
  }

  /// Bit i is set if box i has a point in common with the region.
  [[nodiscard]] unsigned Kept(const FourBoxes& boxes) const {
    LaneFlags outside{0, 0, 0, 0};
    Lanes side;
    for (std::size_t k = 0; k < 3; ++k) {
      Load(boxes.rows[k], side);
      outside |= side > box_.hi[k];
      Load(boxes.rows[k + 3], side);
      outside |= side < box_.lo[k];
    }
    return ~Gather(outside) & ((1U << kLanes) - 1);
  }

  /// Whether the whole of a box lies in the region.
  [[nodiscard]] bool Holds(const Box& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (box.lo[k] < box_.lo[k] || box.hi[k] > box_.hi[k]) return false;
    }
    return true;
  }

 private:
  Box box_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_BOX_OVERLAP_H_
