// SPDX-License-Identifier: GPL-3.0-or-later
// The normal of a facet as a receiver can carry it.

#ifndef TRUELUX_SCENE_FACET_NORMAL_H_
#define TRUELUX_SCENE_FACET_NORMAL_H_

#include "truelux/geometry.h"
#include "truelux/scene.h"

namespace truelux {

/// A normal on the front of a facet, of any length: the smallest vector of
/// whole numbers that is perpendicular to it, if these are at most 2^53, so
/// that it is exact; otherwise divided by its largest component, each
/// component within 1 ulp. facet: index into Scene::facets().
[[nodiscard]] Vector3 FacetNormal(const Scene& scene, int facet);

}  // namespace truelux

#endif  // TRUELUX_SCENE_FACET_NORMAL_H_
