// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as numbers: one irradiance a pixel.

#ifndef TRUELUX_IMAGE_IRRADIANCE_IMAGE_H_
#define TRUELUX_IMAGE_IRRADIANCE_IMAGE_H_

#include <cstdint>

#include "truelux/geometry.h"

#include "image/raster.h"

namespace truelux {

/// Both rasters have the same size.
struct IrradianceImage {
  Raster<Rgb> values;            ///< E [W/m^2]; 0 where nothing is
  Raster<std::uint8_t> covered;  ///< 1: a receiver; 0: nothing, transparent
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_IRRADIANCE_IMAGE_H_
