// SPDX-License-Identifier: GPL-3.0-or-later
// The maps of a receiver's four charts as one view, without the charts' cuts.

#ifndef TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_
#define TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_

#include <span>
#include <vector>

#include "base/ids.h"
#include "exact/primitive.h"
#include "visibility/arrangement/arrangement_view.h"
#include "visibility/contour.h"

namespace truelux {

/// A direction in which arcs of a view meet.
struct GluedVertex {
  Vec3<Exact> direction;
  PrimitiveVector key;  ///< the same, to be compared
  bool on_horizon = false;
  /// What is seen right around it: facets, none for nothing; sorted.
  std::vector<FacetId> around;
};

/// A piece of the border between two faces, or of the horizon. It ends where
/// any edge crosses it, seen or hidden.
struct GluedArc {
  int from = -1;  ///< index into GluedView::vertices
  int to = -1;
  /// Facets on both sides, none: nothing, kOutside: below the horizon. from x to
  /// points to the left side.
  FacetId left;
  FacetId right;
  int left_region = -1;   ///< number of the region, from 0
  int right_region = -1;  ///< -1: below the horizon
  /// A part of it, in its sense, in which nothing changes on either side.
  int piece_from = -1;
  int piece_to = -1;

  [[nodiscard]] bool on_horizon() const { return right == kOutside; }
};

/// Regions are the connected parts of the hemisphere that show one face, or
/// nothing. Arcs on the horizon have it on their right.
struct GluedView {
  std::vector<GluedVertex> vertices;
  std::vector<GluedArc> arcs;
  int region_count = 0;
};

/// charts: WholeChartViewOf the same query, all four.
GluedView Glue(const ContourQuery& query, std::span<const ChartView> charts);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_
