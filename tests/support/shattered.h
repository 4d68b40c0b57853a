// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_TESTS_SUPPORT_SHATTERED_H_
#define TRUELUX_TESTS_SUPPORT_SHATTERED_H_

#include <cstddef>
#include <vector>

#include "truelux/scene.h"

namespace truelux::testing {

/// The same scene with every triangle of every face as a face of its own.
inline Scene Shattered(const Scene& scene) {
  SceneBuilder builder;
  for (const Triangle& t : scene.triangles()) {
    std::vector<Point3> ring;
    for (const int v : t.vertices)
      ring.push_back(scene.vertices()[static_cast<std::size_t>(v)]);
    const Facet& facet = scene.facets()[static_cast<std::size_t>(t.facet)];
    builder.AddFace(
        ring, scene.faces()[static_cast<std::size_t>(facet.face)].emission);
  }
  return *builder.Build().value;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_SHATTERED_H_
