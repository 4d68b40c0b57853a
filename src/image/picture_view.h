// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture shows, and which receivers its pixels are.

#ifndef TRUELUX_IMAGE_PICTURE_VIEW_H_
#define TRUELUX_IMAGE_PICTURE_VIEW_H_

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

#include "image/camera_frame.h"
#include "image/pixel_receivers.h"
#include "image/surface_frame.h"

namespace truelux {

/// More pixels would not fit into the memory of many a computer: a picture
/// takes about a hundred bytes a pixel.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;

/// Throws UsageError if a picture has more than kMaxPixels.
void CheckPixelCount(int width, int height);

/// The name of a surface, or a camera.
using PictureSubject = std::variant<std::string, CameraFrame>;

/// The size of a picture [px].
struct PictureSize {
  int width = 0;
  int height = 0;  ///< 0: pixels of a surface are about square
};

/// Where the pixels of a picture lie in a scene.
struct PictureFrame {
  std::variant<SurfaceFrame, CameraFrame> frame;
  std::vector<Diagnostic> notes;  ///< what the user should know about it
};

/// Finds the subject in a scene. Notes if faces of a surface look to different
/// sides. Throws UserError if there is no such surface, or if it is not flat.
[[nodiscard]] PictureFrame FrameOf(const Scene& scene,
                                   const PictureSubject& subject);

/// The receivers of the pixels. frame: of this scene. A camera needs both
/// sides of the size. Throws UserError if a surface has too many pixels or
/// coordinates that are too large.
[[nodiscard]] std::unique_ptr<PixelReceivers> ReceiversOf(
    const Scene& scene, const PictureFrame& frame, const PictureSize& size);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PICTURE_VIEW_H_
