#include "cli/render_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "explain/edge_text.h"
#include "image/camera_frame.h"
#include "image/camera_pixels.h"
#include "image/surface_frame.h"
#include "image/surface_pixels.h"
#include "run/messages.h"
#include "run/user_error.h"
#include "scene/group_selection.h"

namespace truelux {
namespace {

/// What exists instead of a name that does not.
std::string NamesText(const Scene& scene) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> names;
  for (const Face& face : scene.faces()) {
    const std::string& name =
        scene.group_names()[static_cast<std::size_t>(face.group)];
    if (!name.empty() && std::ranges::find(names, name) == names.end())
      names.push_back(name);
  }
  if (names.empty()) return "the scene names no objects and no groups";
  const std::size_t more = names.size() > kMost ? names.size() - kMost : 0;
  names.resize(names.size() - more);
  std::string text = fmt::format("there are '{}'", fmt::join(names, "', '"));
  if (more > 0) text += fmt::format(" and {} more", more);
  return text;
}

SurfaceFrame FrameOf(const std::string& name, const Scene& scene) {
  const std::vector<int> groups = GroupsNamed(scene, name);
  const std::vector<int> faces = FacesOf(scene, groups);
  if (faces.empty()) {
    throw UserError(fmt::format("--surface: no object or group '{}'; {}", name,
                                NamesText(scene)));
  }
  std::string defect;
  std::optional<SurfaceFrame> frame = SurfaceFrameOf(scene, faces, defect);
  if (!frame) {
    throw UserError(
        fmt::format("--surface: '{}' is no flat surface: {}", name, defect));
  }
  if (!frame->reversed.empty()) {
    PrintNote(fmt::format(
        "the faces of '{}' do not all look to one side ({} and {} differ): "
        "each pixel has the side of its own face",
        name, TextOfFace(scene, frame->faces.front() + 1),
        TextOfFace(scene, frame->reversed.front() + 1)));
  }
  return std::move(*frame);
}

/// The number of rows that makes pixels about square.
int HeightFor(const SurfaceFrame& frame, int width) {
  const double rows = std::round(width * frame.HeightByWidth());
  if (!(rows <= static_cast<double>(kMaxPixels))) {
    throw UserError(
        "--size: the surface is too long for square pixels; give WxH");
  }
  return std::max(1, static_cast<int>(rows));
}

}  // namespace

std::unique_ptr<PixelReceivers> ReceiversOf(const RenderRequest& request,
                                            const Scene& scene) {
  if (request.camera) {
    std::string defect;
    // The request has been checked.
    const CameraFrame frame = CameraFrameOf(*request.camera, defect).value();
    return std::make_unique<CameraPixels>(scene, frame, request.width,
                                          request.height);
  }
  const SurfaceFrame frame = FrameOf(request.surface, scene);
  const int height =
      request.height > 0 ? request.height : HeightFor(frame, request.width);
  CheckPixelCount(request.width, height);
  auto pixels =
      std::make_unique<SurfacePixels>(scene, frame, request.width, height);
  if (!pixels->IsFinite()) {
    throw UserError("--surface: its coordinates are too large for pictures");
  }
  return pixels;
}

}  // namespace truelux
