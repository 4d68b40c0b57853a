// SPDX-License-Identifier: GPL-3.0-or-later
// From irradiances to the bytes of a picture file.

#ifndef TRUELUX_IMAGE_PICTURE_H_
#define TRUELUX_IMAGE_PICTURE_H_

#include <string>
#include <vector>

#include "truelux/diagnostics.h"

#include "image/irradiance_image.h"
#include "image/picture_style.h"

namespace truelux {

/// A picture file, and what the user should know about it.
struct Picture {
  std::string bytes;
  /// How many values are too large for binary64 or binary32, and what is shown
  /// as white if the style does not say.
  std::vector<Diagnostic> notes;
};

/// The picture of the irradiance.
[[nodiscard]] Picture PictureOf(const IrradianceImage& image,
                                const PictureStyle& style);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_H_
