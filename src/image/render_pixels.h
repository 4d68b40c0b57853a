// SPDX-License-Identifier: GPL-3.0-or-later
// From pixels to irradiances, over threads.

#ifndef TRUELUX_IMAGE_RENDER_PIXELS_H_
#define TRUELUX_IMAGE_RENDER_PIXELS_H_

#include <cstdint>

#include "truelux/irradiance.h"

#include "explain/shadow_class.h"
#include "image/irradiance_image.h"
#include "image/pixel_receivers.h"
#include "image/raster.h"
#include "run/progress.h"

namespace truelux {

/// What is wanted besides the irradiance.
struct PixelWishes {
  bool bounds = false;
  bool differences = false;  ///< |double - certified|
  bool arcs = false;
  bool classes = false;
};

/// What pixels have; a raster that is not wished for is empty.
struct RenderedPixels {
  IrradianceImage image;
  Raster<Rgb> bounds;         ///< as in Irradiance
  Raster<Rgb> differences;    ///< |value - the other method's|
  Raster<std::int32_t> arcs;  ///< 0 where there is no receiver
  Raster<ShadowClass> classes;
};

/// Evaluates the receivers of all pixels. The result does not depend on the
/// number of threads. Counts pixels in `progress`, those without a receiver,
/// too. Throws Interruption within one receiver per thread after the program
/// was interrupted.
RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_RENDER_PIXELS_H_
