// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/emitters.h"

#include <algorithm>
#include <cstddef>

namespace truelux {

bool Emits(const Face& face) {
  return std::ranges::any_of(face.emission, [](double m) { return m > 0; });
}

std::vector<int> EmittersOf(const Scene& scene) {
  std::vector<int> emitters;
  for (std::size_t i = 0; i < scene.faces().size(); ++i) {
    const Face& face = scene.faces()[i];
    if (Emits(face) && face.facet_count > 0)
      emitters.push_back(static_cast<int>(i));
  }
  return emitters;
}

bool IsGrey(const Scene& scene) {
  return std::ranges::all_of(scene.faces(), [](const Face& face) {
    return face.emission[0] == face.emission[1] &&
           face.emission[1] == face.emission[2];
  });
}

}  // namespace truelux
