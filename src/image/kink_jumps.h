// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a flat surface the gradient of irradiance jumps, and how far.

#ifndef TRUELUX_IMAGE_KINK_JUMPS_H_
#define TRUELUX_IMAGE_KINK_JUMPS_H_

#include "truelux/irradiance.h"
#include "truelux/rendered_pixels.h"

#include "image/pixel_receivers.h"
#include "run/watch.h"
#include "surface/surface_frame.h"

namespace truelux {

/// Follows the trace of every plane of EdgePlanesOf over the surface, pixel by
/// pixel: where it crosses the middle of a column (a row, if it is steep),
/// two lines of the plane overlap before a source (PlaneSight), and both sides
/// are on the surface, the gradient is taken a millionth of a pixel to either
/// side, by the oracle's method. The jump is their difference: what changes
/// steadily adds its change over two millionths of a pixel. Where a face
/// stands on the surface E itself jumps: that is no kink, and counts as none.
///
/// frame: of receivers, whose pixels are those of SurfacePixels. The result does
/// not depend on the number of threads. Throws Stopped.
[[nodiscard]] KinkJumps FindKinkJumps(const Oracle& oracle,
                                      const SurfaceFrame& frame,
                                      const PixelReceivers& receivers,
                                      int threads, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_KINK_JUMPS_H_
