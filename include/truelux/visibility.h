// The visible contour: what a receiver sees of the sources, as plain data.

#ifndef TRUELUX_VISIBILITY_H_
#define TRUELUX_VISIBILITY_H_

#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/statistics.h"

namespace truelux {

/// What a vertex of a visible contour is; of several, the first that holds.
enum class VertexKind {
  kIntrinsic,  ///< a scene vertex
  kHorizon,    ///< a point of the receiver plane
  kApparent,   ///< two edges that cross only as seen from the receiver, or an
               ///< edge and the line where two faces meet
};

/// One vertex of a visible contour. Counted are the edges and vertices that
/// could show there: those of the source and of what lies in front of its
/// plane, hidden or not, without inner edges of faces and of blocking meshes.
struct ContourVertex {
  VertexKind kind = VertexKind::kApparent;
  /// Several vertices coincide exactly: two scene vertices in line, an edge
  /// that passes through a scene vertex, more than two edges through one
  /// apparent vertex, or any of these on the horizon.
  bool conjunctive = false;
  /// Number of distinct planes through r that carry edges through it (the
  /// receiver plane counts if the vertex lies on the horizon).
  int planes = 0;
  int vertex = -1;    ///< kIntrinsic: index into Scene::vertices(), else -1
  Vector3 direction;  ///< from the receiver, largest component 1 in absolute
                      ///< value; each component within 1 ulp
};

/// One arc of a visible contour: part of the great circle in the plane with
/// normal `plane_normal`, run through so that the visible side is on the right
/// for a viewer at the receiver looking out (counter-clockwise on an image plane
/// seen from above): (from x to) . plane_normal >= 0 and plane_normal points to
/// the visible side.
struct ContourArc {
  int from = 0;  ///< index into VisibleContour::vertices
  int to = 0;
  int source = 0;  ///< face number (1-based) of the source it bounds
  /// Face number (1-based) of the face whose edge it lies on; 0: the horizon.
  /// For the line where a blocker enters the source's plane: the blocker.
  int edge_face = 0;
  Vector3 plane_normal;  ///< largest component 1 in absolute value
};

/// The visible contours of all sources seen from one receiver. An arc ends
/// where the contour turns or at a scene vertex, whatever the engine; edges
/// between the triangles of one face that is not planar are none.
struct VisibleContour {
  std::vector<ContourVertex> vertices;
  std::vector<ContourArc> arcs;
  Statistics statistics;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_H_
