// SPDX-License-Identifier: GPL-3.0-or-later
// Logarithmic axes and what is written along them.

#ifndef TRUELUX_DRAW_SVG_AXIS_H_
#define TRUELUX_DRAW_SVG_AXIS_H_

#include <limits>
#include <string>

namespace truelux {

/// A logarithmic axis over whole decades.
struct DecadeAxis {
  int low = std::numeric_limits<int>::max();  ///< decimal exponents
  int high = std::numeric_limits<int>::min();

  /// Widens the axis to a value > 0, with room for a label on either side.
  void Cover(double value);

  /// 0 at the low end, 1 at the high end. Requires that something is covered.
  [[nodiscard]] double At(double value) const;
};

/// 10^exponent microseconds in a handy unit: "100 ns", "1 µs", "10 ms".
std::string TimeLabel(int exponent);

}  // namespace truelux

#endif  // TRUELUX_DRAW_SVG_AXIS_H_
