// SPDX-License-Identifier: GPL-3.0-or-later
// How far a value is from the truth at one receiver.

#ifndef TRUELUX_EXPLAIN_VALUE_ERROR_H_
#define TRUELUX_EXPLAIN_VALUE_ERROR_H_

#include <cstddef>
#include <optional>

#include "truelux/geometry.h"

namespace truelux {

/// How far a value is from the truth at one receiver, over its three channels.
/// A value that is no number, or infinite where the truth is not, is
/// infinitely far.
struct ValueError {
  bool exact = false;  ///< all three channels are the certified numbers
  /// The largest |value - truth| / truth over the channels with truth > 0;
  /// nothing if there are none.
  std::optional<double> relative;
  double absolute = 0;  ///< the largest |value - truth| [W/m^2]
  /// A channel whose truth is 0 has a value that is not 0.
  bool false_light = false;
  std::size_t channel = 0;  ///< that `relative`, or else `absolute`, is of
};

[[nodiscard]] ValueError ErrorOf(const Rgb& value, const Rgb& truth);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_VALUE_ERROR_H_
