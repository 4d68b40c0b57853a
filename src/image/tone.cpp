// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/tone.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "text/quantile.h"

namespace truelux {

double AutomaticWhite(const IrradianceImage& image) {
  std::vector<double> largest;
  for (const Rgb& value : image.values.pixels()) {
    const double most = *std::ranges::max_element(value);
    if (most > 0 && std::isfinite(most)) largest.push_back(most);
  }
  return largest.empty() ? 1 : Quantile(std::move(largest), kWhiteShare);
}

std::uint8_t SrgbCode(double intensity) {
  // IEC 61966-2-1. Written so that a NaN is black.
  if (!(intensity > 0)) return 0;
  const double x = std::min(intensity, 1.0);
  const double code =
      x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * code));
}

Raster<Rgba8> Toned(const IrradianceImage& image, double white) {
  Raster<Rgba8> picture(image.values.width(), image.values.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (image.covered.pixels()[i] == 0) continue;
    const Rgb& value = image.values.pixels()[i];
    picture.pixels()[i] = {SrgbCode(value[0] / white),
                           SrgbCode(value[1] / white),
                           SrgbCode(value[2] / white), 255};
  }
  return picture;
}

}  // namespace truelux
