// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver sees, whole: the exact planar maps of its four charts. Arcs
// and angular spans are both read from it.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_VIEW_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_VIEW_H_

#include <cstddef>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "scene/coplanar_order.h"
#include "visibility/arrangement/arrangement_chart.h"
#include "visibility/arrangement/arrangement_map.h"
#include "visibility/contour.h"

namespace truelux {

/// What one receiver needs to know of a facet.
struct FacetView {
  bool blocks = false;     ///< takes part: not ignored, not edge-on
  bool is_source = false;  ///< emits to r, and has a point above the horizon
  Vec3<Exact> normal;      ///< points to the front
  Exact height;            ///< normal . (p - r); negative: r is in front

  /// The facet of this id as the receiver sees it.
  [[nodiscard]] SeenFacet Seen(FacetId facet) const {
    return {facet, SignOf(height) == Sign::kNegative};
  }
};

/// What a receiver needs to know of every facet of a scene.
using FacetViews = IdSpan<FacetId, const FacetView>;

/// One entry per facet of the query's scene.
IdVector<FacetId, FacetView> FacetViewsOf(const ContourQuery& query);

/// One chart and what is front-most in it.
struct ChartView {
  ViewChart chart;
  ViewMap map;
};

/// The charts that hold some of a source, hidden or not. views: FacetViewsOf
/// the same query.
std::vector<ChartView> ChartViewsOf(const ContourQuery& query,
                                    FacetViews views);

/// One of the four charts, by its number from 0, with closed walls, whatever it
/// holds.
ChartView WholeChartViewOf(const ContourQuery& query, FacetViews views,
                           std::size_t chart);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_VIEW_H_
