// SPDX-License-Identifier: GPL-3.0-or-later
// Text in pictures made of pixels.

#ifndef TRUELUX_IMAGE_BITMAP_TEXT_H_
#define TRUELUX_IMAGE_BITMAP_TEXT_H_

#include <string_view>

#include "truelux/raster.h"

#include "image/png_image.h"

namespace truelux {

/// Size of a character [px at scale 1], and from one to the next.
inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 7;
inline constexpr int kGlyphAdvance = 6;

/// The width of a text [px].
[[nodiscard]] int TextWidth(std::string_view text, int scale);

/// Draws a text with its left upper corner at (x, y); every dot of a character
/// is a square of `scale` pixels. Characters that are not printable ASCII are
/// drawn as '?'; what is outside the picture is left out.
void DrawText(Raster<Rgba8>& picture, int x, int y, int scale,
              std::string_view text, const Rgba8& colour);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_BITMAP_TEXT_H_
