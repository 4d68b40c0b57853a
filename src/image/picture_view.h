// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture shows, and which receivers its pixels are. What is wrong begins
// with the name of the argument, as "surface: ".

#ifndef TRUELUX_IMAGE_PICTURE_VIEW_H_
#define TRUELUX_IMAGE_PICTURE_VIEW_H_

#include <memory>
#include <variant>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/render.h"
#include "truelux/scene.h"

#include "image/camera_frame.h"
#include "image/pixel_receivers.h"
#include "surface/surface_frame.h"

namespace truelux {

/// Throws std::invalid_argument if a picture has more than kMaxPixels.
void CheckPixelCount(int width, int height);

/// Where the pixels of a picture lie in a scene.
struct PictureFrame {
  std::variant<SurfaceFrame, CameraFrame> frame;
  std::vector<Diagnostic> notes;  ///< what the user should know about it
};

/// Finds the subject in a scene. Notes if faces of a surface look to different
/// sides. Throws std::invalid_argument if there is no such surface, if it is not flat,
/// or if the camera cannot see.
[[nodiscard]] PictureFrame FrameOf(const Scene& scene,
                                   const PictureSubject& subject);

/// The receivers of the pixels. frame: of this scene. Without a height a camera's
/// picture is square. Throws std::invalid_argument if there are too many pixels,
/// or if a surface has coordinates that are too large.
[[nodiscard]] std::unique_ptr<PixelReceivers> ReceiversOf(
    const Scene& scene, const PictureFrame& frame, const PictureSize& size);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_VIEW_H_
