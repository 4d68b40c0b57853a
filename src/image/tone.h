// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance as colours of a display.

#ifndef TRUELUX_IMAGE_TONE_H_
#define TRUELUX_IMAGE_TONE_H_

#include <cstdint>

#include "truelux/rendered_pixels.h"

#include "image/png_image.h"

namespace truelux {

/// The share of pixels that an automatic white level leaves below white.
inline constexpr double kWhiteShare = 0.99;

/// The irradiance [W/m^2] that is shown as white unless the user says: the
/// kWhiteShare quantile of the largest channel over the pixels where it is
/// above 0 and finite; 1 if there is none.
[[nodiscard]] double AutomaticWhite(const IrradianceImage& image);

/// The sRGB code of a linear intensity: 0 and less is 0, 1 and more is 255.
[[nodiscard]] std::uint8_t SrgbCode(double intensity);

/// Each channel divided by `white` (> 0), cut at 1, by the sRGB curve.
[[nodiscard]] Raster<Rgba8> Toned(const IrradianceImage& image, double white);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_TONE_H_
