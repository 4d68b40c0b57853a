// SPDX-License-Identifier: GPL-3.0-or-later
// The maps of a receiver's four charts as one view, without the charts' cuts.

#ifndef TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_
#define TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_

#include <span>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/primitive.h"
#include "visibility/arrangement/arrangement_view.h"
#include "visibility/contour.h"

namespace truelux {

/// Index into GluedView::vertices.
using GluedVertexId = Id<struct GluedVertexTag>;
/// Index into GluedView::arcs.
using GluedArcId = Id<struct GluedArcTag>;
/// Number of a region, from 0.
using RegionId = Id<struct RegionTag>;

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
  GluedVertexId from;
  GluedVertexId to;
  /// Facets on both sides, none: nothing, kOutside: below the horizon. from x to
  /// points to the left side.
  FacetId left;
  FacetId right;
  RegionId left_region;
  RegionId right_region;  ///< none: below the horizon
  /// A part of it, in its sense, in which nothing changes on either side.
  GluedVertexId piece_from;
  GluedVertexId piece_to;

  [[nodiscard]] bool on_horizon() const { return right == kOutside; }
};

/// Regions are the connected parts of the hemisphere that show one face, or
/// nothing. Arcs on the horizon have it on their right.
struct GluedView {
  IdVector<GluedVertexId, GluedVertex> vertices;
  IdVector<GluedArcId, GluedArc> arcs;
  int region_count = 0;
};

/// charts: WholeChartViewOf the same query, all four.
GluedView Glue(const ContourQuery& query, std::span<const ChartView> charts);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_GLUED_VIEW_H_
