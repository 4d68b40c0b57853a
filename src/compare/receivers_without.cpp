// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/receivers_without.h"

#include <algorithm>
#include <cstddef>

#include "scene/scene_access.h"
#include "visibility/contour.h"

namespace truelux {

/// The faces, as indices, with a facet in a plane of the named face.
const std::vector<int>& ReceiversWithout::FacesInPlaneOf(int on_face) {
  const auto [entry, is_new] = faces_in_plane_.try_emplace(on_face);
  if (!is_new) return entry->second;
  Receiver receiver{{0, 0, 0}, {0, 0, 1}, on_face};
  const IdVector<FacetId, bool> ignored = IgnoredFacets({scene_, receiver});
  for (const FacetId f : ignored.ids()) {
    if (ignored[f]) entry->second.push_back(FaceOf(scene_, f).value());
  }
  return entry->second;
}

std::vector<Receiver> ReceiversWithout::Of(std::span<const Receiver> receivers,
                                           std::span<const int> faces) {
  std::vector<bool> removed(scene_.faces().size(), false);
  for (const int face : faces)
    removed[static_cast<std::size_t>(face)] = true;
  std::vector<Receiver> moved(receivers.begin(), receivers.end());
  for (Receiver& receiver : moved) {
    const int face = receiver.on_face;
    if (face == 0 || !removed[static_cast<std::size_t>(face - 1)]) continue;
    const std::vector<int>& in_plane = FacesInPlaneOf(face);
    const auto other = std::ranges::find_if(
        in_plane, [&](int f) { return !removed[static_cast<std::size_t>(f)]; });
    receiver.on_face = other == in_plane.end() ? 0 : *other + 1;
  }
  return moved;
}

std::optional<std::vector<Receiver>> ReceiversOnFaces(
    const Scene& scene, std::span<const Receiver> receivers) {
  std::vector<Receiver> moved(receivers.begin(), receivers.end());
  bool any = false;
  for (Receiver& receiver : moved) {
    if (receiver.on_face != 0) continue;
    const std::optional<NearFace> face = scene.FaceNear(receiver);
    if (!face) continue;
    receiver.on_face = face->number;
    any = true;
  }
  if (!any) return std::nullopt;
  return moved;
}

}  // namespace truelux
