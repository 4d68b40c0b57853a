// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a false-colour picture.

#ifndef TRUELUX_IMAGE_PICTURE_SCALE_H_
#define TRUELUX_IMAGE_PICTURE_SCALE_H_

#include "truelux/picture.h"
#include "truelux/raster.h"

#include "image/false_colour.h"

namespace truelux {

/// What is shown, and by which colours.
struct PictureScale {
  ScalarChannel channel = ScalarChannel::kLuminance;
  Raster<double> values;  ///< of the channel [W/m^2]; NaN where nothing is
  double largest = 0;
  double top = 1;  ///< where the scale ends
  ColourScale scale = ColourScale::Linear(1);
};

/// style: of a false-colour picture.
[[nodiscard]] PictureScale PictureScaleOf(const IrradianceImage& image,
                                          const PictureStyle& style);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_SCALE_H_
