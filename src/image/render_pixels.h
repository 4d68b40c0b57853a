// SPDX-License-Identifier: GPL-3.0-or-later
// From pixels to irradiances, over threads.

#ifndef TRUELUX_IMAGE_RENDER_PIXELS_H_
#define TRUELUX_IMAGE_RENDER_PIXELS_H_

#include "truelux/irradiance.h"

#include "image/pixel_part.h"
#include "image/pixel_receivers.h"
#include "image/rendered_pixels.h"
#include "run/progress.h"

namespace truelux {

/// What is wanted besides the irradiance.
struct PixelWishes {
  bool bounds = false;
  bool differences = false;  ///< |double - certified|
  bool arcs = false;
  bool classes = false;
  bool gradients = false;  ///< lengths of tangential gradients
};

/// Evaluates the receivers of all pixels. The result does not depend on the
/// number of threads. Counts pixels in `progress`, those without a receiver,
/// too. part: has the tiles that earlier runs have done, and keeps those that
/// are done now; may be null. Throws Interruption within one receiver per
/// thread after the program was interrupted.
RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            PixelPart* part, Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_RENDER_PIXELS_H_
