// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace truelux {
namespace {

double DistanceTo(const PaperPoint& a, const PaperPoint& b, double x,
                  double y) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double share =
      square > 0
          ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0)
          : 0;
  return std::hypot(x - a.x - share * dx, y - a.y - share * dy);
}

/// The whole number below, within 0 .. count.
int Within(double x, int count) {
  return static_cast<int>(
      std::clamp(std::floor(x), 0.0, static_cast<double>(count)));
}

/// Adds what a segment covers of pixels, in shares of 255.
void Cover(Raster<std::uint8_t>& covered, const PaperPoint& a,
           const PaperPoint& b, double width) {
  const double reach = 0.5 * width + 0.5;
  const int right = Within(std::max(a.x, b.x) + reach + 1, covered.width());
  const int bottom = Within(std::max(a.y, b.y) + reach + 1, covered.height());
  for (int y = Within(std::min(a.y, b.y) - reach, covered.height()); y < bottom;
       ++y) {
    for (int x = Within(std::min(a.x, b.x) - reach, covered.width()); x < right;
         ++x) {
      const double share =
          std::clamp(reach - DistanceTo(a, b, x + 0.5, y + 0.5), 0.0, 1.0);
      covered.At(x, y) =
          std::max(covered.At(x, y),
                   static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
}

std::uint8_t Mixed(std::uint8_t below, std::uint8_t above, std::uint8_t share) {
  return static_cast<std::uint8_t>(
      (below * (255 - share) + above * share + 127) / 255);
}

}  // namespace

void DrawLines(Raster<Rgba8>& picture, std::span<const PaperPath> lines,
               double width, const Rgba8& colour) {
  Raster<std::uint8_t> covered(picture.width(), picture.height());
  for (const PaperPath& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i)
      Cover(covered, line[i - 1], line[i], width);
  }
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    Rgba8& pixel = picture.pixels()[i];
    const std::uint8_t share = covered.pixels()[i];
    if (share == 0 || pixel.alpha == 0) continue;
    pixel.red = Mixed(pixel.red, colour.red, share);
    pixel.green = Mixed(pixel.green, colour.green, share);
    pixel.blue = Mixed(pixel.blue, colour.blue, share);
  }
}

}  // namespace truelux
