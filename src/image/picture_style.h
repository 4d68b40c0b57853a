// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers become a picture file.

#ifndef TRUELUX_IMAGE_PICTURE_STYLE_H_
#define TRUELUX_IMAGE_PICTURE_STYLE_H_

#include <optional>
#include <vector>

#include "image/exr_image.h"
#include "image/scalar_channel.h"

namespace truelux {

/// The look of the picture of the irradiance. An EXR file holds the numbers
/// themselves, so that only `texts` matters there.
struct PictureStyle {
  bool is_exr = false;           ///< otherwise a PNG
  std::vector<ImageText> texts;  ///< what an EXR file carries
  /// What is shown as white, or at the top of the scale [W/m^2], above 0;
  /// nothing: what suits the picture.
  std::optional<double> white;
  bool false_colour = false;  ///< one channel by colours of a scale
  bool isolux = true;         ///< with false_colour: lines at the ticks
  /// The channel of false_colour; nothing: the luminance.
  std::optional<ScalarChannel> channel;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_STYLE_H_
