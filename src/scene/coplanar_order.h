// SPDX-License-Identifier: GPL-3.0-or-later
// Which of several faces in one plane is seen where they overlap.

#ifndef TRUELUX_SCENE_COPLANAR_ORDER_H_
#define TRUELUX_SCENE_COPLANAR_ORDER_H_

#include <tuple>

#include "truelux/scene.h"

#include "base/ids.h"
#include "scene/scene_access.h"

namespace truelux {

/// A facet as a receiver sees it.
struct SeenFacet {
  FacetId facet;
  bool shows_front = false;
};

/// The class of a facet among those in its plane, the first class in front:
/// emitters that show their front, emitters that emit to both sides and show
/// their back, other fronts, other backs. Emitters are those of the scene's
/// file, whatever a variant of the scene emits: so the same faces are seen in
/// all variants, and sums over sources add up.
inline int CoplanarClass(const Scene& scene, const SeenFacet& seen) {
  const Facet& facet = FacetsOf(scene)[seen.facet];
  if (!seen.shows_front) return 3;
  if (!FacesOf(scene)[FaceOf(facet)].is_emitter) return 2;
  return facet.is_back ? 1 : 0;
}

/// Whether of two facets in one plane the first is seen where both are: it has
/// the lower class, or comes earlier in the scene. Properties: (1) a strict
/// order of the facets in one plane; (2) a facet that emits is hidden in its
/// own plane only by an earlier one that emits.
inline bool IsSeenBefore(const Scene& scene, const SeenFacet& a,
                         const SeenFacet& b) {
  return std::tuple(CoplanarClass(scene, a), a.facet) <
         std::tuple(CoplanarClass(scene, b), b.facet);
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_COPLANAR_ORDER_H_
