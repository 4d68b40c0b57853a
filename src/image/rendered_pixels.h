// SPDX-License-Identifier: GPL-3.0-or-later
// What the pixels of a picture have.

#ifndef TRUELUX_IMAGE_RENDERED_PIXELS_H_
#define TRUELUX_IMAGE_RENDERED_PIXELS_H_

#include <cstdint>
#include <optional>

#include "truelux/geometry.h"

#include "explain/shadow_class.h"
#include "image/irradiance_image.h"
#include "image/kink_jumps.h"
#include "image/raster.h"

namespace truelux {

/// A raster that is not wished for is empty.
struct RenderedPixels {
  IrradianceImage image;
  Raster<Rgb> bounds;         ///< as in Irradiance
  Raster<Rgb> differences;    ///< |value - the other method's|
  Raster<std::int32_t> arcs;  ///< 0 where there is no receiver
  Raster<ShadowClass> classes;
  Raster<Rgb> gradients;  ///< lengths of tangential gradients [W/m^3]
  /// How far these jump, on a surface; RenderPixels leaves that to
  /// FindKinkJumps.
  std::optional<KinkJumps> kinks;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_RENDERED_PIXELS_H_
