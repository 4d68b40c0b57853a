// SPDX-License-Identifier: GPL-3.0-or-later
// Kinks drawn over a picture.

#ifndef TRUELUX_IMAGE_KINK_LINES_H_
#define TRUELUX_IMAGE_KINK_LINES_H_

#include "truelux/raster.h"

#include "image/png_image.h"

namespace truelux {

/// The colour of the lines.
inline constexpr Rgba8 kKinkColour = {255, 255, 255, 255};

/// Draws the pixels whose jump is at least `least` in white, and darkens those
/// beside them, so that the lines stand out on any colour. Transparent pixels
/// stay. jumps: of the picture's size. least: above 0.
void DrawKinkLines(Raster<Rgba8>& picture, const Raster<double>& jumps,
                   double least);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_KINK_LINES_H_
