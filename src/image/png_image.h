// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as PNG files.

#ifndef TRUELUX_IMAGE_PNG_IMAGE_H_
#define TRUELUX_IMAGE_PNG_IMAGE_H_

#include <cstdint>
#include <string>

#include "truelux/raster.h"

namespace truelux {

/// A pixel of the sRGB colour space; alpha 0 is transparent, 255 opaque.
struct Rgba8 {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t alpha = 0;

  friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// The bytes of a PNG file. Throws std::runtime_error if the library cannot
/// make it (more than 2^31 bytes of pixels, or no memory).
[[nodiscard]] std::string PngImage(const Raster<Rgba8>& picture);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PNG_IMAGE_H_
