// SPDX-License-Identifier: GPL-3.0-or-later
// Which lamps, and which edges before them, matter to a part of a surface.

#ifndef TRUELUX_ISOLUX_SIGHT_H_
#define TRUELUX_ISOLUX_SIGHT_H_

#include <cstddef>
#include <span>
#include <vector>

#include "isolux/light_features.h"
#include "isolux/plan_frame.h"

namespace truelux {

/// The part of an edge that may be seen before a lamp.
struct SightEdge {
  int edge = 0;     ///< index into LightFeatures::edges()
  double from = 0;  ///< parts of the edge, 0 <= from <= to <= 1
  double to = 1;
};

/// A lamp with the edges in its shaft: the hull of the lamp and the part.
struct LampSight {
  int lamp = 0;  ///< index into LightFeatures::lamps()
  /// First those in the lamp's plane, which sweep nothing and end what others
  /// sweep. None if there are no others: then all of the lamp is seen, or
  /// nothing, from all points alike.
  std::vector<SightEdge> edges;
  std::size_t lamp_edges = 0;  ///< how many these are
  std::vector<int> blockers;   ///< indices into LightFeatures::blockers()
};

using Sight = std::vector<LampSight>;

/// Everything, before it is narrowed.
Sight WholeSight(const LightFeatures& features);

/// What is left of `sight` for the convex hull of some points of the surface:
/// lamps that look to one of them and are not hidden by one blocker, and of edges
/// what is in the shaft, bounds a shadow, and is not hidden. Never drops what matters, but for strips of 2^-40 of the size along
/// planes of facets.
Sight Narrowed(const LightFeatures& features, const Sight& sight,
               std::span<const PlanPoint> points);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_SIGHT_H_
