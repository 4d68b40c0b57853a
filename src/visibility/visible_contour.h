// SPDX-License-Identifier: GPL-3.0-or-later
// From an engine's contour to the public one: vertices told apart exactly and
// classified.

#ifndef TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_
#define TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_

#include <optional>
#include <vector>

#include "truelux/visibility.h"

#include "visibility/contour.h"
#include "visibility/view/seen_edge.h"

namespace truelux {

/// The contour as plain data. Ends that point the same way become one vertex;
/// a vertex is classified by every edge and scene vertex that could show
/// there: those of the source and of what lies in front of its plane, without
/// the inner edges of faces and of blocking meshes. Costs arcs times edges;
/// meant for looking, not for the inner loop. Requires that the contour is not
/// joined.
VisibleContour DescribeContour(const ContourQuery& query,
                               const Contour& contour);

/// The edges at and near a vertex of a visible contour, of those that it is
/// classified by.
struct VertexEdges {
  std::vector<SeenEdge> through;  ///< each once, in their order
  /// The nearest one that does not pass through the vertex, and its angle from
  /// there [rad], > 0; nothing if there is none.
  std::optional<SeenEdge> nearest;
  double nearest_angle = 0;
};

/// A visible contour and, per vertex, its edges.
struct ContourInDetail {
  VisibleContour contour;
  std::vector<VertexEdges> edges;
};

/// DescribeContour with the edges that meet, or all but meet, in each vertex.
ContourInDetail DescribeInDetail(const ContourQuery& query,
                                 const Contour& contour);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_
