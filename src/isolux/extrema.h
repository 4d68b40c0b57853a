// SPDX-License-Identifier: GPL-3.0-or-later
// Maxima, minima and saddles of irradiance on a surface.

#ifndef TRUELUX_ISOLUX_EXTREMA_H_
#define TRUELUX_ISOLUX_EXTREMA_H_

#include <vector>

#include "truelux/isolux.h"

#include "isolux/light_features.h"
#include "isolux/mesh_search.h"
#include "isolux/summits.h"

namespace truelux {

/// Triangles that hang together and are not settled.
struct UnsettledGroup {
  std::vector<int> triangles;
  ValueRange range;
};

/// What is known of one side.
struct CriticalPoints {
  std::vector<CriticalPoint> points;
  std::vector<UnsettledGroup> undecided;
  ValueRange values;  ///< E is in it on all of the side
};

/// The groups of unsettled triangles that hang together by corners.
std::vector<std::vector<int>> GroupsOf(const MeshSearch& search);

/// Reads them off a search that was settled with CriticalGoal, as far as it got.
///
/// Maxima and minima are those of summits.h. Around a group of unsettled
/// triangles without kinks the gradient, which is nowhere 0 there, turns a whole
/// number of times: -1 is a saddle. Of each point of the mesh on a line or an outline whose triangles are all
/// settled: whether E falls, or rises, in all directions from there.
CriticalPoints CriticalPointsOf(const MeshSearch& search,
                                const LightFeatures& features);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_EXTREMA_H_
