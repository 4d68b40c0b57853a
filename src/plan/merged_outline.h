// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of polygons that lie side by side or over each other.

#ifndef TRUELUX_PLAN_MERGED_OUTLINE_H_
#define TRUELUX_PLAN_MERGED_OUTLINE_H_

#include <array>
#include <map>
#include <vector>

namespace truelux {

/// A point on a grid, (x, y).
using GridPoint = std::array<int, 2>;

/// A closed polygon, its first corner not repeated.
using GridRing = std::vector<GridPoint>;

/// Half the sum of x dy - y dx; the area, with a sign for the sense of rotation.
[[nodiscard]] double SignedArea(const GridRing& ring);

/// Puts polygons together. A side that two of them share is left out where they
/// lie on both sides of it.
class MergedOutline {
 public:
  /// The sense of rotation means nothing.
  void Add(const GridRing& ring);

  /// Rings, none of which meets a point twice, that wind around every point as
  /// often as all the polygons do if each of them has a positive area: with
  /// SVG's fill-rule nonzero they fill what the polygons fill. Where polygons
  /// cover each other exactly, a ring is there several times.
  [[nodiscard]] std::vector<GridRing> Rings() const;

 private:
  /// The sides from a lower to a higher point, how often they are there; those
  /// the other way count negative.
  std::map<std::array<GridPoint, 2>, int> sides_;
};

}  // namespace truelux

#endif  // TRUELUX_PLAN_MERGED_OUTLINE_H_
