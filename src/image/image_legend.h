// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours of a picture mean, drawn beside it.

#ifndef TRUELUX_IMAGE_IMAGE_LEGEND_H_
#define TRUELUX_IMAGE_IMAGE_LEGEND_H_

#include <optional>
#include <string>
#include <vector>

#include "truelux/raster.h"

#include "image/false_colour.h"
#include "image/png_image.h"

namespace truelux {

/// A colour with a meaning of its own.
struct Swatch {
  Rgba8 colour;
  std::string text;
  bool is_framed = false;  ///< in ink, if it is as light as the paper
};

struct ImageLegend {
  std::vector<std::string> title;    ///< lines
  std::optional<ColourScale> scale;  ///< as a bar with its ticks, if given
  std::vector<Swatch> swatches;      ///< below it
};

/// The picture with the legend to its right: the picture's pixels are those on
/// the left, from the top, unchanged; a legend that is higher makes the result
/// higher, transparent below the picture.
[[nodiscard]] Raster<Rgba8> WithLegend(const Raster<Rgba8>& picture,
                                       const ImageLegend& legend);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_IMAGE_LEGEND_H_
