// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/scalar_raster.h"

#include <algorithm>

namespace truelux {

double LargestOf(const Raster<double>& values) {
  double largest = 0;
  for (const double value : values.pixels()) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  return largest;
}

Raster<Rgba8> Coloured(const Raster<double>& values, const ColourScale& scale) {
  Raster<Rgba8> picture(values.width(), values.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const double value = values.pixels()[i];
    if (!std::isnan(value)) picture.pixels()[i] = FalseColour(scale.At(value));
  }
  return picture;
}

}  // namespace truelux
