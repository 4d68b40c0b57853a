// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative boxes in a source's plane: cones whose boxes are apart share no
// direction. (Boxes only save time; nothing depends on how tight they are.)

#ifndef TRUELUX_VISIBILITY_EDGES_IMAGE_BOX_H_
#define TRUELUX_VISIBILITY_EDGES_IMAGE_BOX_H_

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "exact/filter.h"
#include "exact/lanes.h"
#include "exact/rounding.h"

namespace truelux {

/// A closed octagon that contains the image: bounds of x, y, x + y and x - y;
/// by default the whole plane.
class ImageBox {
 public:
  ImageBox() = default;

  /// Requires RoundUpward.
  ImageBox(double x_min, double x_max, double y_min, double y_max)
      : lo_{x_min, y_min, -(-x_min - y_min), -(y_max - x_min)},
        hi_{x_max, y_max, x_max + y_max, x_max - y_min} {
    assert(IsRoundingUpward());
  }

  [[nodiscard]] double x_min() const { return lo_[0]; }

  [[nodiscard]] double x_max() const { return hi_[0]; }

  [[nodiscard]] double y_min() const { return lo_[1]; }

  [[nodiscard]] double y_max() const { return hi_[1]; }

  [[nodiscard]] bool Meets(const ImageBox& other) const {
    return AllLessOrEqual(lo_, other.hi_, other.lo_, hi_);
  }

  /// Whether the other box lies in this one.
  [[nodiscard]] bool Contains(const ImageBox& other) const {
    return AllLessOrEqual(lo_, other.lo_, other.hi_, hi_);
  }

  void Include(const ImageBox& other) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      lo_[k] = std::min(lo_[k], other.lo_[k]);
      hi_[k] = std::max(hi_[k], other.hi_[k]);
    }
  }

 private:
  /// Whether a <= b and c <= d; without a branch, as no answer is likely.
  static bool AllLessOrEqual(const LaneArray& a, const LaneArray& b,
                             const LaneArray& c, const LaneArray& d) {
    Lanes left;
    Lanes right;
    Load(a, left);
    Load(b, right);
    const LaneFlags first = left <= right;
    Load(c, left);
    Load(d, right);
    const LaneFlags second = left <= right;
    return Gather(first & second) == (1U << kLanes) - 1;
  }

  LaneArray lo_{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  LaneArray hi_{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

/// Where directions meet a plane parallel to the source's, in two of the three
/// coordinates. Requires RoundUpward.
class ImageChart {
 public:
  ImageChart() = default;

  /// normal: the source's, pointing towards r.
  explicit ImageChart(const FilteredPlane& normal) : away_(normal) {
    away_.v = {-normal.v.x, -normal.v.y, -normal.v.z, normal.v.error};
    const double x = std::fabs(normal.v.x);
    const double y = std::fabs(normal.v.y);
    const double z = std::fabs(normal.v.z);
    dropped_ = z >= x && z >= y ? 2 : (y >= x ? 1 : 0);
  }

  /// The image of one direction; the whole plane unless it certainly points
  /// away from the parallel plane through r.
  ///
  /// The true image x = X / D, the computed one x~ = fl(X~ q), q = fl(1/D~);
  ///   |X~/D~ - X/D| = |X~/D~ (D - D~) + (X~ - X)| / D
  ///                <= (|X~/D~| e_D + e_X) / (D~ - e_D),
  /// and x~ differs from X~/D~ by 2 kDirectedUnit (1 + kDirectedUnit) |X~/D~|. With
  /// e_D <= D~/4 the margin below, 1.5 q (e_X + |x~| (e_D + 4 kDirectedUnit D~)),
  /// covers both: 1/(D~ - e_D) <= 4/3 q.
  ///
  /// misses: whether the direction certainly never meets the source's plane.
  [[nodiscard]] ImageBox Of(const FilteredDirection& d, bool& misses) const {
    assert(IsRoundingUpward());
    const BoundedValue depth = FilteredDot(away_, d);
    misses = -depth.value > depth.error;
    if (!(depth.error * 4 <= depth.value)) return {};
    const double q = 1 / depth.value;
    const double x = (dropped_ == 0 ? d.v.y : d.v.x) * q;
    const double y = (dropped_ == 2 ? d.v.y : d.v.z) * q;
    const double spread = depth.error + 4 * kDirectedUnit * depth.value;
    const double x_margin = 1.5 * q * (d.v.error + std::fabs(x) * spread);
    const double y_margin = 1.5 * q * (d.v.error + std::fabs(y) * spread);
    // Not the difference, which would be rounded up, too.
    const ImageBox box(-(x_margin - x), x + x_margin, -(y_margin - y),
                       y + y_margin);
    // The whole plane if there is a NaN, also from sums of infinities.
    return box.Meets(box) ? box : ImageBox();
  }

 private:
  FilteredPlane away_;
  int dropped_ = 2;  ///< the coordinate along which the normal is longest
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_IMAGE_BOX_H_
