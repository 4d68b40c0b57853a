// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of how an irradiance comes about, with legends.

#ifndef TRUELUX_IMAGE_EXTRA_PICTURE_H_
#define TRUELUX_IMAGE_EXTRA_PICTURE_H_

#include <array>
#include <optional>
#include <string>

#include "image/render_pixels.h"
#include "image/scalar_channel.h"

namespace truelux {

/// A further picture beside the irradiance.
enum class ExtraPicture {
  kError,     ///< |double - certified|
  kArcs,      ///< number of arcs of the visible contour
  kClass,     ///< lit, umbra, penumbra, ...
  kGradient,  ///< length of the tangential gradient, with its kinks if they
              ///< were found
};

inline constexpr std::array kExtraPictures = {
    ExtraPicture::kError, ExtraPicture::kArcs, ExtraPicture::kClass,
    ExtraPicture::kGradient};

/// The word on the command line and in the file's name.
[[nodiscard]] const char* Name(ExtraPicture extra);

/// Sets the wish that the picture needs.
void Wish(ExtraPicture extra, PixelWishes& wishes);

/// The bytes of its PNG file. pixels: rendered with that wish. channel: the one
/// of kError and kGradient; nothing: the largest of each pixel.
[[nodiscard]] std::string ExtraPictureOf(ExtraPicture extra,
                                         const RenderedPixels& pixels,
                                         std::optional<ScalarChannel> channel);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_EXTRA_PICTURE_H_
