// SPDX-License-Identifier: GPL-3.0-or-later
// The visible contour: what a receiver sees of the sources, as plain data.

#ifndef TRUELUX_VISIBILITY_H_
#define TRUELUX_VISIBILITY_H_

#include <string_view>
#include <vector>

#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/statistics.h"

namespace truelux {

/// What a vertex of a visible contour is. If several hold, it is the first of
/// them.
enum class VertexKind {
  kIntrinsic,  ///< "intrinsic": a scene vertex
  kHorizon,    ///< "horizon": a point of the plane through the receiver that
               ///< its normal is perpendicular to
  kApparent,   ///< "apparent": two edges that cross only as seen from the
               ///< receiver, or an edge and the line where two faces meet
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(VertexKind kind);

/// One vertex of a visible contour. `conjunctive` and `planes` count the edges
/// and vertices that could show at it: those of the source and of what lies in
/// front of the source's plane, hidden or not. Edges between the triangles of
/// one face, and edges that two blocking faces share inside a mesh, do not
/// count.
struct ContourVertex {
  VertexKind kind = VertexKind::kApparent;
  /// Several vertices coincide exactly: two scene vertices in line, an edge
  /// that passes through a scene vertex, more than two edges through one
  /// apparent vertex, or any of these on the horizon.
  bool conjunctive = false;
  /// Number of distinct planes through the receiver that carry edges through
  /// the vertex. The receiver plane counts if the vertex lies on the horizon.
  int planes = 0;
  /// kIntrinsic: index into Scene::vertices(), from 0; otherwise -1.
  int vertex = -1;
  /// From the receiver to the vertex, in the scene's frame. Its largest
  /// component is 1 in absolute value; each component is within 1 ulp.
  Vector3 direction;
};

/// One arc of a visible contour: part of a great circle around the receiver,
/// shorter than half of it. For a viewer at the receiver who looks out, the
/// visible side is on the right when going from `from` to `to`. With the
/// directions of these vertices, (from x to) . plane_normal >= 0.
struct ContourArc {
  int from = 0;    ///< index into VisibleContour::vertices, from 0
  int to = 0;      ///< index into VisibleContour::vertices, from 0
  int source = 0;  ///< number, from 1, of the emitting face that it bounds
  /// Number, from 1, of the face whose edge the arc lies on; 0: the horizon.
  /// Where a blocker cuts through the source's plane: the blocker.
  int edge_face = 0;
  /// Normal of the circle's plane, in the scene's frame; it points to the
  /// visible side. Its largest component is 1 in absolute value.
  Vector3 plane_normal;
};

/// The visible contours of all sources seen from one receiver. The arcs of a
/// source bound exactly what is visible of it. An arc ends where the contour
/// turns or at a scene vertex, whatever the engine. Edges between the
/// triangles of one face that is not planar have no arcs.
struct VisibleContour {
  std::vector<ContourVertex> vertices;  ///< each direction once
  std::vector<ContourArc> arcs;         ///< source by source
  Statistics statistics;                ///< what the visibility cost
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_H_
