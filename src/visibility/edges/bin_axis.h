// SPDX-License-Identifier: GPL-3.0-or-later
// Equal bins along one direction of a frame.

#ifndef TRUELUX_VISIBILITY_EDGES_BIN_AXIS_H_
#define TRUELUX_VISIBILITY_EDGES_BIN_AXIS_H_

#include <cmath>
#include <cstddef>

namespace truelux {

class BinAxis {
 public:
  /// From min to max. bins: at least 1.
  void Start(double min, double max, std::size_t bins) {
    bins_ = bins;
    origin_ = min;
    scale_ = static_cast<double>(bins) / (max - min);
  }

  /// Whether it has a length and an end, so that the bins differ.
  [[nodiscard]] bool IsProper() const {
    return scale_ > 0 && scale_ < HUGE_VAL;
  }

  /// The bin of a coordinate, clamped to the frame. Not decreasing in x, for any
  /// origin and scale: what begins at or before x has no later bin.
  [[nodiscard]] std::size_t Bin(double x) const {
    const double position = (x - origin_) * scale_;
    if (!(position > 0)) return 0;  // NaN, too: 0 times infinity
    const auto last = static_cast<double>(bins_ - 1);
    return position >= last ? bins_ - 1 : static_cast<std::size_t>(position);
  }

 private:
  std::size_t bins_ = 1;
  double origin_ = 0;
  double scale_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_BIN_AXIS_H_
