// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a receiver sees, as plain data: regions of the hemisphere,
// the arcs between them, and the vertices where arcs meet.
//
// The geometry is found exactly, by the arrangement engine; the directions and
// planes here are rounded (two vertices may then have equal directions). No
// trace of the engine's charts is left.

#ifndef TRUELUX_VISIBILITY_VIEW_VIEW_DATA_H_
#define TRUELUX_VISIBILITY_VIEW_VIEW_DATA_H_

#include <vector>

#include "truelux/visibility.h"

#include "visibility/view/seen_edge.h"

namespace truelux {

/// What an arc is; of several, the first that holds.
enum class ViewArcKind {
  kHorizon,     ///< on the receiver plane, the border of the hemisphere
  kSilhouette,  ///< a face ends, and another one farther away or nothing is
                ///< seen beyond
  kInner,       ///< an edge that the faces on both sides share
  kContact,     ///< an edge of one face that touches the other face, or lies
                ///< in its plane
  kMeeting,     ///< the line where the faces on both sides pass through each
                ///< other
};

/// Part of a great circle between two regions.
struct WholeViewArc {
  /// Indices into WholeView::vertices. An arc that is the whole horizon has
  /// from = to = -1, or, if one vertex lies there, from = to = that vertex.
  int from = -1;
  int to = -1;
  bool at_least_pi = false;  ///< so long; only arcs on the horizon can be
  /// Unit-free normal of its plane, largest component 1 in absolute value,
  /// each within 1 ulp. The arc runs counter-clockwise about it, and it points
  /// to the left region. On the horizon: along the receiver's normal.
  Vector3 plane_normal;
  int left = -1;   ///< index into WholeView::regions
  int right = -1;  ///< the same; -1: below the horizon
  ViewArcKind kind = ViewArcKind::kSilhouette;
  SeenEdge edge;  ///< on which it lies; face 0: the horizon
};

/// A closed border of a region, run through with the region on the left.
struct ViewLoop {
  std::vector<int> arcs;  ///< indices into WholeView::arcs, one after the other
};

/// A connected part of the hemisphere in which one face is seen, or nothing.
struct ViewRegion {
  int face = 0;        ///< its number (1-based), 0: nothing
  int facet = -1;      ///< the first of its facets seen there, -1: nothing
  bool front = false;  ///< the receiver is in front of that facet
  std::vector<ViewLoop> loops;
};

/// A vertex with the edges that coincide in it. If it is a vertex of the visible
/// contour of a source, these are the edges that count there (ContourVertex);
/// for others, all edges, seen or hidden, that are not behind the farthest face
/// seen around it (all if nothing is seen beyond), without diagonals of faces.
struct WholeViewVertex {
  ContourVertex vertex;
  bool bounds_source = false;   ///< of the visible contour of a source
  std::vector<SeenEdge> edges;  ///< sorted
  /// vertex.planes and, where it is conjunctive, those of further edges in the
  /// same direction, behind all that is seen around it.
  int planes_with_hidden = 0;
};

struct WholeView {
  std::vector<WholeViewVertex> vertices;
  std::vector<WholeViewArc> arcs;
  std::vector<ViewRegion> regions;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_VIEW_DATA_H_
