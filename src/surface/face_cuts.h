// SPDX-License-Identifier: GPL-3.0-or-later
// The lines where faces that emit are pierced.

#ifndef TRUELUX_SURFACE_FACE_CUTS_H_
#define TRUELUX_SURFACE_FACE_CUTS_H_

#include <array>
#include <set>
#include <vector>

#include "truelux/scene.h"
#include "truelux/stop.h"

#include "exact/rational.h"

namespace truelux {

/// A segment in which two triangles meet, with its exact ends.
using FaceCut = std::array<RationalVector, 2>;

/// The segments in which triangles of two facets in different planes meet, one
/// of which emits. What is seen may change there as at an edge, although there
/// is none. Where a facet touches another one with an edge of its outline is no
/// cut. outlines: edges by indices into Scene::vertices(), ascending. stop: may
/// be null. Throws Stopped.
[[nodiscard]] std::vector<FaceCut> FaceCutsOf(
    const Scene& scene, const std::set<std::array<int, 2>>& outlines,
    const StopFlag* stop);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_FACE_CUTS_H_
