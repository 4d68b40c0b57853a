// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a flat surface the gradient of irradiance jumps, and how far.

#ifndef TRUELUX_IMAGE_KINK_JUMPS_H_
#define TRUELUX_IMAGE_KINK_JUMPS_H_

#include "truelux/geometry.h"
#include "truelux/irradiance.h"

#include "image/pixel_receivers.h"
#include "image/raster.h"
#include "image/surface_frame.h"

namespace truelux {

/// Jumps of the tangential gradient, pixel by pixel.
struct KinkJumps {
  /// The largest length of a jump in the pixel, per channel [W/m^3]; 0 where
  /// there is none.
  Raster<Rgb> lengths;
  /// Whether nothing was measured, since there are more places to measure at
  /// than pixels.
  bool is_left_out = false;
  /// Whether kinks may be missing, EdgePlanes::is_complete being false.
  bool is_partial = false;
};

/// Follows the trace of every plane of EdgePlanesOf over the surface, pixel by
/// pixel: where it crosses the middle of a column (a row, if it is steep),
/// two lines of the plane overlap before a source (PlaneSight), and both sides
/// are on the surface, the gradient is taken a millionth of a pixel to either
/// side, by the oracle's method. The jump is their difference: what changes
/// steadily adds its change over two millionths of a pixel. Where a face
/// stands on the surface E itself jumps: that is no kink, and counts as none.
///
/// frame: of receivers, whose pixels are those of SurfacePixels. The result does
/// not depend on the number of threads. Throws Interruption and Stopped.
[[nodiscard]] KinkJumps FindKinkJumps(const Oracle& oracle,
                                      const SurfaceFrame& frame,
                                      const PixelReceivers& receivers,
                                      int threads);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_KINK_JUMPS_H_
