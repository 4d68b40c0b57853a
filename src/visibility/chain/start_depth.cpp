// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain/start_depth.h"

#include <algorithm>
#include <cmath>

#include "scene/scene_access.h"

namespace truelux {

/// A ray that holds the true direction of the position; nothing if nothing is
/// known of it. With s = 1 - t the direction is s u + t v, u and v the edge's
/// ends: an error e of t moves it by at most e (|u| + |v|).
template <class Geometry>
std::optional<RayBoxes> StartDepth<Geometry>::RayThrough(
    const ViewEdge& edge, const EdgePosition& position) {
  const FilteredDirection& u = geometry_.DirectionFilter(edge.from);
  const FilteredDirection& v = geometry_.DirectionFilter(edge.to);
  ApproxVector d;
  if (position.plane == kFromEnd) {
    d = u.v;
  } else {
    const double t = position.parameter;
    const double s = 1 - t;
    d = {s * u.v.x + t * v.v.x, s * u.v.y + t * v.v.y, s * u.v.z + t * v.v.z,
         u.v.error + v.v.error +
             (u.max + v.max) * (position.error + 4 * kDirectedUnit)};
  }
  const double size =
      std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (!(d.error < 0x1p-10 * size) || !(size > 0x1p-500) || !(size < 0x1p500)) {
    return std::nullopt;
  }
  // The ray reaches the source's plane where t = height / speed.
  const TriangleId triangle = source_.plane().triangle();
  const FilteredPlane& normal = geometry_.TriangleNormalFilter(triangle);
  const VertexId corner = CornersOf(TrianglesOf(scene_)[triangle])[0];
  const BoundedValue height =
      FilteredDot(normal, FilteredDifference(geometry_.view().position,
                                             VerticesOf(scene_)[corner]));
  const BoundedValue speed = FilteredDot(normal, MakeFilteredDirection(d));
  const double most_height = height.error - height.value;
  const double minus_least_speed = speed.error + speed.value;
  const double end =
      minus_least_speed < 0 ? most_height / -minus_least_speed : HUGE_VAL;
  return RayBoxes(geometry_.view().position, d, end >= 0 ? end : HUGE_VAL);
}

template <class Geometry>
bool StartDepth<Geometry>::Holds(PieceId piece, const ViewEdge& edge,
                                 const EdgePosition& position, bool on_positive,
                                 const ImageBox& near) {
  Part part;
  ImageBox box;
  if (!blockers_.MayBlock(piece, box) || !box.Meets(near) ||
      ignored_.IsIgnored(index_.pieces().pieces()[piece].facet) ||
      !blockers_.MakePart(piece, part, box)) {
    return false;
  }
  cones_.Complete(part.cone);
  Cover cover;
  if (!CoverOf(geometry_, edge, part.cone, cover)) return false;
  if (cover.side != Sign::kZero &&
      (cover.side == Sign::kPositive) != on_positive) {
    return false;
  }
  if (ComparePositions(geometry_, edge, cover.begin, position) ==
          Sign::kPositive ||
      ComparePositions(geometry_, edge, position, cover.end) !=
          Sign::kNegative) {
    return false;
  }
  hides_all_ = hides_all_ || blockers_.HidesAll(part.cone, box);
  return true;
}

template <class Geometry>
int StartDepth<Geometry>::At(const ViewEdge& edge, const EdgePosition& position,
                             bool on_positive, const Shaft& shaft) {
  ++counts_.queries;
  int depth = 0;
  // A box around the position.
  const ImageBox near = source_.plane().BoxOfEdge(
      edge.from, position.plane == kFromEnd ? edge.from : edge.to);
  const auto count = [&](int piece) {
    if (Holds(PieceId(piece), edge, position, on_positive, near)) ++depth;
  };
  if (const auto ray = RayThrough(edge, position)) {
    index_.tree().Visit(*ray, count);
  } else {
    ++counts_.wide;
    index_.tree().Visit(shaft, count);
  }
  return depth;
}

template class StartDepth<ViewGeometry>;
template class StartDepth<UnfilteredViewGeometry>;
template class StartDepth<DisplacedViewGeometry>;

}  // namespace truelux
