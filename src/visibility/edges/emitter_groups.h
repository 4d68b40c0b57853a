// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_EDGES_EMITTER_GROUPS_H_
#define TRUELUX_VISIBILITY_EDGES_EMITTER_GROUPS_H_

#include <cstddef>
#include <vector>

#include "truelux/scene.h"

#include "base/ids.h"
#include "scene/index/convex_pieces.h"

namespace truelux {

/// Index of an emitting facet among a scene's, in their order.
using EmitterId = Id<struct EmitterTag>;

/// Facets of one plane that have their chain and their images in common: they
/// lie in exactly one plane, look to the same side, are connected by edges that
/// two of them share, and overlap no facet that emits, neither each other nor
/// another one. So none of them hides another. Those that emit the same are one
/// source where only the sum over all sources counts: what is seen of them is
/// bounded by their common outline alone.
struct EmitterGroup {
  std::vector<FacetId> facets;  ///< those that emit the same are consecutive
  /// Where in `facets` those that emit the same end; the last is the size.
  std::vector<std::size_t> alike_ends;
};

/// The groups of a scene of at least two facets. Those that emit the same come
/// in ascending order.
[[nodiscard]] std::vector<EmitterGroup> EmitterGroupsOf(
    const Scene& scene, const ConvexPieces& pieces);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_EMITTER_GROUPS_H_
