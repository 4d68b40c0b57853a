// SPDX-License-Identifier: GPL-3.0-or-later
// How far a value is from the truth at one receiver.

#ifndef TRUELUX_EXPLAIN_VALUE_ERROR_H_
#define TRUELUX_EXPLAIN_VALUE_ERROR_H_

#include "truelux/comparison.h"
#include "truelux/geometry.h"

namespace truelux {

/// Of all three channels.
[[nodiscard]] ValueError ErrorOf(const Rgb& value, const Rgb& truth);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_VALUE_ERROR_H_
