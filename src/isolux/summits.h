// SPDX-License-Identifier: GPL-3.0-or-later
// Maxima and minima of irradiance that are proven by values alone.

#ifndef TRUELUX_ISOLUX_SUMMITS_H_
#define TRUELUX_ISOLUX_SUMMITS_H_

#include <vector>

#include "truelux/isolux.h"

#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/mesh_search.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A critical point of one side of a surface.
struct CriticalPoint {
  ExtremumKind kind = ExtremumKind::kMaximum;
  PlanPoint at;
  LightValue value;
  ValueRange range;
  double radius = 0;  ///< [length]
  SideKind on = SideKind::kInner;
};

/// A point of the mesh that is higher than all that is around the triangles that
/// may be as high: E is continuous, so that there is a maximum in these. A
/// minimum likewise.
struct Summit {
  CriticalPoint point;
  std::vector<int> triangles;
};

/// E on a triangle: what is known, and no more than lamps give unblocked.
ValueRange LightRangeOf(const MeshSearch& search, const LightFeatures& features,
                        int triangle);

/// All summits of at most some thousand triangles. Where E is 0 there is none.
std::vector<Summit> SummitsOf(const MeshSearch& search,
                              const LightFeatures& features);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_SUMMITS_H_
