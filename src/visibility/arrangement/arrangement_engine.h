// SPDX-License-Identifier: GPL-3.0-or-later
// The twin: the whole view as an exact lower envelope (docs/method.md).

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_

#include <span>

#include "visibility/arrangement/arrangement_view.h"
#include "visibility/contour.h"

namespace truelux {

/// The visible contours of the query's sources, found without any of the
/// contour engine's code. Slow. Planes and directions are explicit.
Contour ContourByArrangement(const ContourQuery& query);

/// The same from a map that is there already: facets are FacetViewsOf the
/// query, charts are ChartViewsOf it.
Contour ContourByArrangement(const ContourQuery& query, FacetViews facets,
                             std::span<const ChartView> charts);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_
