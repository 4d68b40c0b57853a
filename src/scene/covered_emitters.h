// SPDX-License-Identifier: GPL-3.0-or-later
// Emitters that others hide in their own plane.

#ifndef TRUELUX_SCENE_COVERED_EMITTERS_H_
#define TRUELUX_SCENE_COVERED_EMITTERS_H_

#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// A face that emits, and an earlier one that is seen instead of it.
struct CoveredEmitter {
  int face = 0;   ///< index into Scene::faces()
  int cover = 0;  ///< index, smaller; the first such face
};

/// The faces that emit and of which a part with an area is covered by an
/// earlier face that emits to the same side of the same plane. Decided exactly;
/// ascending. Takes n log n for n triangles that emit, if few of them overlap.
[[nodiscard]] std::vector<CoveredEmitter> CoveredEmittersOf(const Scene& scene);

}  // namespace truelux

#endif  // TRUELUX_SCENE_COVERED_EMITTERS_H_
