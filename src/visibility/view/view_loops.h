// SPDX-License-Identifier: GPL-3.0-or-later
// The borders of regions, arc after arc.

#ifndef TRUELUX_VISIBILITY_VIEW_VIEW_LOOPS_H_
#define TRUELUX_VISIBILITY_VIEW_VIEW_LOOPS_H_

#include <vector>

#include "visibility/view/glued_view.h"
#include "visibility/view/view_data.h"

namespace truelux {

/// The loops around each region. planes: of each arc the exact normal of its
/// plane, to its left. At a vertex a loop goes on with the next arc
/// around it, so that nothing but the region lies between the two.
IdVector<RegionId, std::vector<ViewLoop>> LoopsOf(
    const GluedView& view, IdSpan<GluedArcId, const Vec3<Exact>> planes);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_VIEW_LOOPS_H_
