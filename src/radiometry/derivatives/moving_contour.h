// SPDX-License-Identifier: GPL-3.0-or-later
// A visible contour as what moves when the receiver or a vertex does: per arc
// the space line that it lies on, exactly.
//
// Letters: r the receiver, n its normal; S the source of an arc, T a face that
// pierces its plane; a and b the ends of a scene edge, relative to r; N the
// normal of the arc's plane and L the direction of its line, N = a x L for
// every point a of the line; d1 and d2 the directions of the arc's ends, d1 x
// d2 a positive multiple of N.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_MOVING_CONTOUR_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_MOVING_CONTOUR_H_

#include <vector>

#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"
#include "visibility/contour.h"

namespace truelux {

/// What an arc lies on.
enum class ArcLine {
  kHorizon,  ///< the receiver plane: it moves with neither r nor a vertex
  kEdge,     ///< a scene edge
  kCut,      ///< the line where the planes of two triangles meet
};

/// One arc.
struct MovingArc {
  SourceId source;
  ArcLine kind = ArcLine::kHorizon;
  /// Whether N points out of the visible side.
  bool outward = false;
  Vec3<Exact> normal;  ///< N
  Vec3<Exact> line;    ///< L; of kHorizon (0, 0, 0)
  Vec3<Exact> first;   ///< d1
  Vec3<Exact> last;    ///< d2
  FaceNumber face;     ///< whose edge it is, if known
  VertexId from;       ///< of kEdge: its ends, L = b - a
  VertexId to;
  TriangleId source_triangle;  ///< of kCut: of S, and N = h_T N_S - h_S N_T
  TriangleId other_triangle;   ///< of kCut: of T
  /// Of kCut: whether N and L are turned, N = h_S N_T - h_T N_S.
  bool turned = false;
};

/// The arcs of a contour, exactly.
struct MovingContour {
  Vec3<Exact> receiver_normal;
  std::vector<MovingArc> arcs;  ///< source after source
};

/// view: of the contour; it may be displaced (exact/displacement.h), and all
/// is then as it is seen from there.
MovingContour MovingContourOf(const ReceiverView& view, const Contour& contour);

/// Splits the arcs on cuts where they go from one triangle of a face to the
/// next, so that source_triangle and other_triangle are those that the cut goes
/// through: their corners say how it moves. The rest stays as it is.
void SplitCuts(const ReceiverView& view, const Scene& scene,
               MovingContour& contour);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_MOVING_CONTOUR_H_
