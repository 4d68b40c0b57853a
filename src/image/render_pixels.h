// SPDX-License-Identifier: GPL-3.0-or-later
// From pixels to irradiances, over threads.

#ifndef TRUELUX_IMAGE_RENDER_PIXELS_H_
#define TRUELUX_IMAGE_RENDER_PIXELS_H_

#include "truelux/irradiance.h"
#include "truelux/render.h"
#include "truelux/rendered_pixels.h"

#include "image/pixel_part.h"
#include "image/pixel_receivers.h"
#include "run/progress.h"

namespace truelux {

/// Evaluates the receivers of all pixels. The result does not depend on the
/// number of threads. Counts pixels in `progress`, those without a receiver,
/// too. part: has the tiles that earlier runs have done, and keeps those that
/// are done now; may be null. Throws Stopped within one receiver per
/// thread after the watch of `progress` asks for it.
RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            PixelPart* part, Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_RENDER_PIXELS_H_
