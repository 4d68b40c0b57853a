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

#include "explain/edge_text.h"
#include "image/camera_pixels.h"
#include "image/surface_pixels.h"
#include "scene/group_selection.h"
#include "scene/io/quoted.h"

namespace truelux {
namespace {

/// What exists instead of a name that does not.
std::string NamesText(const Scene& scene) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> names;
  std::vector<bool> is_named(scene.group_names().size(), false);
  for (const Face& face : scene.faces()) {
    const auto group = static_cast<std::size_t>(face.group);
    const std::string& name = scene.group_names()[group];
    if (!name.empty() && !is_named[group]) names.push_back(Quoted(name));
    is_named[group] = true;
  }
  if (names.empty()) return "the scene names no objects and no groups";
  const std::size_t more = names.size() > kMost ? names.size() - kMost : 0;
  names.resize(names.size() - more);
  std::string text = fmt::format("there are {}", fmt::join(names, ", "));
  if (more > 0) text += fmt::format(" and {} more", more);
  return text;
}

SurfaceFrame FrameNamed(const Scene& scene, const std::string& name) {
  const std::vector<int> faces = FacesOf(scene, GroupsNamed(scene, name));
  if (faces.empty()) {
    throw std::invalid_argument(fmt::format(
        "surface: no object or group {}; {}", Quoted(name), NamesText(scene)));
  }
  std::string defect;
  std::optional<SurfaceFrame> frame = SurfaceFrameOf(scene, faces, defect);
  if (!frame) {
    throw std::invalid_argument(fmt::format(
        "surface: {} is no flat surface: {}", Quoted(name), defect));
  }
  return std::move(*frame);
}

std::vector<Diagnostic> NotesOn(const Scene& scene, const std::string& name,
                                const SurfaceFrame& frame) {
  if (frame.reversed.empty()) return {};
  return {{Severity::kNote, "", 0,
           fmt::format("the faces of {} do not all look to one side ({} and "
                       "{} differ): each pixel has the side of its own face",
                       Quoted(name), TextOfFace(scene, frame.faces.front() + 1),
                       TextOfFace(scene, frame.reversed.front() + 1))}};
}

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
  const auto& name = std::get<std::string>(subject);
  SurfaceFrame frame = FrameNamed(scene, name);
  std::vector<Diagnostic> notes = NotesOn(scene, name, frame);
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
