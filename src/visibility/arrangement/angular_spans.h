// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver sees around every vertex of its view: the angular spans of
// vertex tracing (Stark & Riesenfeld 2000, section 3.2), exactly.
//
// A vertex is any direction where edges of the view meet: a corner of a facet,
// edges that cross, both at once, or any number of them. Whatever coincides
// there has already been sorted out, since the sectors are cells of an exact
// planar map. So there is one kind of vertex, and a visible direction has only
// one span list in a chart, however many corners and crossings fall together.
//
// Frame: the scene's, origin moved to r.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ANGULAR_SPANS_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ANGULAR_SPANS_H_

#include <span>
#include <vector>

#include "truelux/statistics.h"

#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"
#include "visibility/arrangement/arrangement_view.h"
#include "visibility/contour.h"

namespace truelux {

/// A sector between two neighbouring edges at a vertex v. It begins at the
/// first of them, on the side to which edge_plane points.
struct AngularSpan {
  FacetId facet;           ///< seen in it; none also beyond the chart
  bool is_source = false;  ///< whether that facet emits towards r
  Vec3<Exact> edge_end;    ///< direction of the other end of the edge
  Vec3<Exact> edge_plane;  ///< normal of the edge's plane: v x edge_end
};

/// A vertex and the spans around it, in the order of a right-handed turn about
/// v; at least two, neighbours with different facets, the last one before the
/// first.
struct SpanVertex {
  Vec3<Exact> direction;  ///< v
  std::vector<AngularSpan> spans;
};

/// All vertices at which a source is seen, in no order: each says by itself
/// what it contributes. A direction on a cut between charts occurs once in
/// each chart, with what that chart sees around it.
struct AngularSpans {
  std::vector<SpanVertex> vertices;
  Statistics statistics;  ///< the predicates' part
};

/// The angular spans of the query's view, read from the same planar maps as
/// the arrangement engine's arcs. Slow. query.join_sources is not used.
AngularSpans AngularSpansOf(const ContourQuery& query);

/// The same from a map that is there already: facets are FacetViewsOf the
/// query, charts are ChartViewsOf it.
AngularSpans AngularSpansOf(FacetViews facets,
                            std::span<const ChartView> charts);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ANGULAR_SPANS_H_
