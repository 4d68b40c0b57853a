// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/kink_lines.h"

#include <algorithm>
#include <cstdint>

namespace truelux {
namespace {

Rgba8 Darkened(const Rgba8& colour) {
  const auto part = [](std::uint8_t code) {
    return static_cast<std::uint8_t>(code * 2 / 5);
  };
  return {part(colour.red), part(colour.green), part(colour.blue),
          colour.alpha};
}

}  // namespace

void DrawKinkLines(Raster<Rgba8>& picture, const Raster<double>& jumps,
                   double least) {
  const auto is_line = [&](int x, int y) {
    return jumps.Contains(x, y) && jumps.At(x, y) >= least;
  };
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      Rgba8& colour = picture.At(x, y);
      if (colour.alpha == 0) continue;
      if (is_line(x, y)) {
        colour = kKinkColour;
      } else if (is_line(x - 1, y) || is_line(x + 1, y) || is_line(x, y - 1) ||
                 is_line(x, y + 1)) {
        colour = Darkened(colour);
      }
    }
  }
}

}  // namespace truelux
