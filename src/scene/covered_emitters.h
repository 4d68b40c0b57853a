// SPDX-License-Identifier: GPL-3.0-or-later
// Emitters that others hide in their own plane.

#ifndef TRUELUX_SCENE_COVERED_EMITTERS_H_
#define TRUELUX_SCENE_COVERED_EMITTERS_H_

#include <cstdint>
#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// A face that emits, and an earlier one that is seen instead of it.
struct CoveredEmitter {
  int face = 0;   ///< index into Scene::faces()
  int cover = 0;  ///< index, smaller; one of such faces
};

struct CoveredEmitters {
  std::vector<CoveredEmitter> found;  ///< by face, ascending
  bool is_all = true;  ///< false: the search ended early, see below
};

/// The faces that emit and of which a part with an area is covered by an
/// earlier face that emits to the same side of the same plane. Decided exactly.
/// Takes n log n for n triangles that emit, if few of their boxes overlap; after
/// kMostCoverTests pairs, less than a second, it ends.
[[nodiscard]] CoveredEmitters CoveredEmittersOf(const Scene& scene);

inline constexpr std::int64_t kMostCoverTests = 5'000'000;

}  // namespace truelux

#endif  // TRUELUX_SCENE_COVERED_EMITTERS_H_
