// SPDX-License-Identifier: GPL-3.0-or-later
// All numbers of a picture.

#ifndef TRUELUX_IMAGE_RENDER_FRAME_H_
#define TRUELUX_IMAGE_RENDER_FRAME_H_

#include "truelux/irradiance.h"
#include "truelux/render.h"
#include "truelux/rendered_pixels.h"

#include "image/picture_view.h"
#include "image/pixel_part.h"
#include "image/pixel_receivers.h"
#include "run/watch.h"

namespace truelux {

/// RenderPixels and, of a surface whose gradients are wished for, FindKinkJumps.
/// receivers: ReceiversOf the frame, perhaps on other faces. part: may be null.
/// Throws Stopped.
[[nodiscard]] RenderedPixels RenderFrame(const Oracle& oracle,
                                         const PictureFrame& frame,
                                         const PixelReceivers& receivers,
                                         const PixelWishes& wishes, int threads,
                                         PixelPart* part, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_RENDER_FRAME_H_
