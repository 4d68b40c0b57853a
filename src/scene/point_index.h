// SPDX-License-Identifier: GPL-3.0-or-later
// Gives equal points the same number.

#ifndef TRUELUX_SCENE_POINT_INDEX_H_
#define TRUELUX_SCENE_POINT_INDEX_H_

#include <cstddef>
#include <vector>

#include "truelux/geometry.h"

namespace truelux {

/// A hash set of points that remembers the order in which they came. Points
/// are equal if their coordinates are; -0 is stored as +0.
class PointIndex {
 public:
  /// The index of a point with finite coordinates; the next free one if it is
  /// new.
  int Insert(const Point3& point);

  /// The points by index; leaves the set empty.
  std::vector<Point3> TakePoints();

 private:
  [[nodiscard]] std::size_t SlotOf(const Point3& point) const;
  void Grow();

  std::vector<Point3> points_;
  std::vector<int> slots_;  ///< open addressing; -1: free; size a power of 2
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_POINT_INDEX_H_
