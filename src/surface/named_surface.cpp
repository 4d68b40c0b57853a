// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/named_surface.h"

#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

#include "explain/edge_text.h"
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
                       "{} differ): each point has the side of its own face",
                       Quoted(name), TextOfFace(scene, frame.faces.front() + 1),
                       TextOfFace(scene, frame.reversed.front() + 1))}};
}

}  // namespace

NamedSurface SurfaceNamed(const Scene& scene, const std::string& name) {
  SurfaceFrame frame = FrameNamed(scene, name);
  std::vector<Diagnostic> notes = NotesOn(scene, name, frame);
  return {std::move(frame), std::move(notes)};
}

}  // namespace truelux
