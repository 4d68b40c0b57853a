// SPDX-License-Identifier: GPL-3.0-or-later
// Contours drawn over a picture, with their levels in gaps.

#ifndef TRUELUX_IMAGE_CONTOUR_DRAWING_H_
#define TRUELUX_IMAGE_CONTOUR_DRAWING_H_

#include <span>

#include "truelux/picture.h"
#include "truelux/raster.h"

#include "image/false_colour.h"
#include "image/png_image.h"

namespace truelux {

/// Draws smooth lines, black on colours that are light on the scale and white on
/// dark ones. Numbers stand in gaps of the lines, if the picture is at least 160
/// pixels wide and high. contours: ascending levels.
void DrawContours(Raster<Rgba8>& picture,
                  std::span<const PictureContour> contours,
                  const ColourScale& scale);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_CONTOUR_DRAWING_H_
