// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/isolux.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace truelux {

Raster<std::uint8_t> IsoluxLines(const Raster<double>& values,
                                 std::span<const double> levels) {
  const int width = values.width();
  const int height = values.height();
  // How many levels a value has reached.
  const auto reached = [&levels](double value) {
    return std::ranges::upper_bound(levels, value) - levels.begin();
  };
  Raster<std::uint8_t> lines(width, height, 0);
  // Beside and below; the neighbour's other ones come in its own turn.
  constexpr std::array<std::pair<int, int>, 2> kNext = {{{1, 0}, {0, 1}}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double value = values.At(x, y);
      if (std::isnan(value)) continue;
      for (const auto& [right, down] : kNext) {
        const int nx = x + right;
        const int ny = y + down;
        if (!values.Contains(nx, ny) || std::isnan(values.At(nx, ny))) continue;
        const auto here = reached(value);
        const auto there = reached(values.At(nx, ny));
        if (here < there) lines.At(x, y) = 1;
        if (there < here) lines.At(nx, ny) = 1;
      }
    }
  }
  return lines;
}

}  // namespace truelux
