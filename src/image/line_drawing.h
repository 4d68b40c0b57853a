// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth lines in pictures made of pixels.

#ifndef TRUELUX_IMAGE_LINE_DRAWING_H_
#define TRUELUX_IMAGE_LINE_DRAWING_H_

#include <span>

#include "truelux/raster.h"

#include "draw/paper_path.h"
#include "image/png_image.h"

namespace truelux {

/// Draws lines of one width [px] and colour with round ends; (0, 0) is the left
/// upper corner of the picture. A pixel gets as much of the colour as the line
/// covers of the distance from its own middle, and no more where lines meet.
/// Transparent pixels stay.
void DrawLines(Raster<Rgba8>& picture, std::span<const PaperPath> lines,
               double width, const Rgba8& colour);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_LINE_DRAWING_H_
