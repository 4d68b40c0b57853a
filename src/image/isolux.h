// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of equal irradiance in a picture.

#ifndef TRUELUX_IMAGE_ISOLUX_H_
#define TRUELUX_IMAGE_ISOLUX_H_

#include <cstdint>
#include <span>

#include "truelux/raster.h"

namespace truelux {

/// 1 for the pixels on a line: of two neighbours (beside or above each other)
/// between which one of the levels is passed, the one with less. So the lines
/// are thin, and mirrored where the values are. values: a NaN has no neighbours.
/// levels: ascending.
[[nodiscard]] Raster<std::uint8_t> IsoluxLines(const Raster<double>& values,
                                               std::span<const double> levels);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_ISOLUX_H_
