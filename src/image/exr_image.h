// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as OpenEXR files.

#ifndef TRUELUX_IMAGE_EXR_IMAGE_H_
#define TRUELUX_IMAGE_EXR_IMAGE_H_

#include <span>
#include <string>

#include "truelux/picture.h"
#include "truelux/rendered_pixels.h"

namespace truelux {

/// The binary32 nearest to a value, ties to even; infinite if it is too large.
[[nodiscard]] float NearestFloat(double value);

/// The bytes of an OpenEXR file: channels R, G, B with E [W/m^2] as binary32
/// (each binary64 rounded once more; what is too large becomes infinite) and A,
/// 1 or, with R = G = B = 0, where nothing is. Lossless compression. The texts
/// become string attributes; the name "comments" is the one that viewers show.
[[nodiscard]] std::string ExrImage(const IrradianceImage& image,
                                   std::span<const ImageText> texts);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_EXR_IMAGE_H_
