// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/picture_scale.h"

#include "base/scalar_channel.h"
#include "image/scalar_raster.h"

namespace truelux {

PictureScale PictureScaleOf(const IrradianceImage& image,
                            const PictureStyle& style) {
  PictureScale shown;
  shown.channel = style.channel.value_or(ScalarChannel::kLuminance);
  shown.values = Scalars(image, image.values, [&](const Rgb& value) {
    return ScalarOf(value, shown.channel);
  });
  shown.largest = LargestOf(shown.values);
  shown.top = style.white.value_or(shown.largest > 0 ? shown.largest : 1);
  shown.scale = ColourScale::Linear(shown.top);
  return shown;
}

}  // namespace truelux
