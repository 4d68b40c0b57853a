// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/picture_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

#include "image/camera_pixels.h"
#include "image/surface_pixels.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// The number of rows that makes pixels about square.
int HeightFor(const SurfaceFrame& frame, int width) {
  const double rows = std::round(width * frame.HeightByWidth());
  if (!(rows <= static_cast<double>(kMaxPixels))) {
    throw std::invalid_argument(
        "size: the surface is too long for square pixels; give WxH");
  }
  return std::max(1, static_cast<int>(rows));
}

std::unique_ptr<PixelReceivers> SurfaceReceivers(const Scene& scene,
                                                 const SurfaceFrame& frame,
                                                 const PictureSize& size) {
  const int height =
      size.height > 0 ? size.height : HeightFor(frame, size.width);
  CheckPixelCount(size.width, height);
  auto pixels =
      std::make_unique<SurfacePixels>(scene, frame, size.width, height);
  if (!pixels->IsFinite()) {
    throw std::invalid_argument(
        "surface: its coordinates are too large for pictures");
  }
  return pixels;
}

}  // namespace

void CheckPixelCount(int width, int height) {
  if (std::int64_t{width} * height <= kMaxPixels) return;
  throw std::invalid_argument(fmt::format(
      "size: {} x {} are more than {} pixels, which is the most that a "
      "picture may have (it takes about 100 bytes of memory a pixel)",
      width, height, kMaxPixels));
}

PictureFrame FrameOf(const Scene& scene, const PictureSubject& subject) {
  if (const auto* camera = std::get_if<Camera>(&subject)) {
    std::string defect;
    const std::optional<CameraFrame> frame = CameraFrameOf(*camera, defect);
    if (!frame) throw std::invalid_argument("camera: " + defect);
    return {*frame, {}};
  }
  auto [frame, notes] = SurfaceNamed(scene, std::get<std::string>(subject));
  return {std::move(frame), std::move(notes)};
}

std::unique_ptr<PixelReceivers> ReceiversOf(const Scene& scene,
                                            const PictureFrame& frame,
                                            const PictureSize& size) {
  if (const auto* camera = std::get_if<CameraFrame>(&frame.frame)) {
    const int height = size.height > 0 ? size.height : size.width;
    CheckPixelCount(size.width, height);
    return std::make_unique<CameraPixels>(scene, *camera, size.width, height);
  }
  return SurfaceReceivers(scene, std::get<SurfaceFrame>(frame.frame), size);
}

}  // namespace truelux
