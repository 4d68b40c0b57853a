// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of one number a pixel, by the colours of a scale.

#ifndef TRUELUX_IMAGE_SCALAR_RASTER_H_
#define TRUELUX_IMAGE_SCALAR_RASTER_H_

#include <cmath>
#include <cstddef>

#include "truelux/raster.h"
#include "truelux/rendered_pixels.h"

#include "image/false_colour.h"
#include "image/png_image.h"

namespace truelux {

/// number(entry of `pixels`) for each pixel with a receiver; NaN for the
/// others. pixels: of the image's size.
template <class T, class Function>
Raster<double> Scalars(const IrradianceImage& image, const Raster<T>& pixels,
                       const Function& number) {
  Raster<double> values(pixels.width(), pixels.height(), std::nan(""));
  for (std::size_t i = 0; i < values.pixels().size(); ++i) {
    if (image.covered.pixels()[i] != 0)
      values.pixels()[i] = number(pixels.pixels()[i]);
  }
  return values;
}

/// The largest finite number; 0 if none is above 0.
[[nodiscard]] double LargestOf(const Raster<double>& values);

/// The colours of the numbers by a scale; transparent where there is a NaN.
[[nodiscard]] Raster<Rgba8> Coloured(const Raster<double>& values,
                                     const ColourScale& scale);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_SCALAR_RASTER_H_
