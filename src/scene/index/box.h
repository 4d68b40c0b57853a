// SPDX-License-Identifier: GPL-3.0-or-later
// Axis-parallel boxes, alone and four at a time.

#ifndef TRUELUX_SCENE_INDEX_BOX_H_
#define TRUELUX_SCENE_INDEX_BOX_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "truelux/geometry.h"

#include "exact/lanes.h"

namespace truelux {

/// A closed box by its least and its greatest coordinates; by default empty.
struct Box {
  std::array<double, 3> lo{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 3> hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  /// The box of one point.
  static Box Of(const Point3& p) { return {{p.x, p.y, p.z}, {p.x, p.y, p.z}}; }

  /// Grows to hold another box. Exact: no number is rounded.
  void Include(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], other.lo[k]);
      hi[k] = std::max(hi[k], other.hi[k]);
    }
  }

  void Include(const Point3& p) { Include(Of(p)); }
};

/// Four boxes side by side, so that one instruction can test all of them.
struct FourBoxes {
  using Row = LaneArray;  ///< one coordinate of each box

  /// lo x, lo y, lo z, hi x, hi y, hi z; by default of empty boxes.
  alignas(32) std::array<Row, 6> rows{};

  FourBoxes() {
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k].fill(HUGE_VAL);
      rows[k + 3].fill(-HUGE_VAL);
    }
  }

  [[nodiscard]] Box Get(std::size_t i) const {
    return {{rows[0][i], rows[1][i], rows[2][i]},
            {rows[3][i], rows[4][i], rows[5][i]}};
  }

  void Set(std::size_t i, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k][i] = box.lo[k];
      rows[k + 3][i] = box.hi[k];
    }
  }
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_BOX_H_
