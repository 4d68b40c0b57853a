// SPDX-License-Identifier: GPL-3.0-or-later
// Arctangents for the double-double atan2.

#ifndef TRUELUX_EXACT_ATAN_TABLE_H_
#define TRUELUX_EXACT_ATAN_TABLE_H_

#include <array>

#include "exact/double_double.h"

namespace truelux {

constexpr int kAtanTableSteps = 256;

/// Entry j is atan(j / 256) as the nearest double and the nearest double of
/// what is left; error <= u^2 (relative). A test derives every entry again
/// with MPFR.
extern const std::array<DoubleDouble, kAtanTableSteps + 1> kAtanTable;

}  // namespace truelux

#endif  // TRUELUX_EXACT_ATAN_TABLE_H_
