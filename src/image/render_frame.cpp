// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/render_frame.h"

#include <variant>

#include "image/kink_jumps.h"
#include "image/render_pixels.h"
#include "run/progress.h"
#include "surface/surface_frame.h"

namespace truelux {

RenderedPixels RenderFrame(const Oracle& oracle, const PictureFrame& frame,
                           const PixelReceivers& receivers,
                           const PixelWishes& wishes, int threads,
                           PixelPart* part, const Watch& watch) {
  RenderedPixels pixels;
  {
    Progress progress(receivers.size(), "pixels", watch);
    pixels = RenderPixels(oracle, receivers, wishes, threads, part, progress);
  }
  const auto* surface = std::get_if<SurfaceFrame>(&frame.frame);
  if (wishes.gradients && surface != nullptr)
    pixels.kinks = FindKinkJumps(oracle, *surface, receivers, threads, watch);
  return pixels;
}

}  // namespace truelux
