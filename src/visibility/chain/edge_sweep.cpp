// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain/edge_sweep.h"

#include <algorithm>
#include <cassert>

namespace truelux {

/// Adds the interval along which another edge, in the plane of the swept one,
/// lies on it. The interval belongs to the edge with the least id.
template <class Geometry>
void EdgeSweep<Geometry>::AddOverlap(ChainEdgeId other) {
  const ViewEdge& e = edge_;
  const ChainEdge& f = chain_.edges()[other];
  Part part;
  ImageBox box = chain_.boxes()[other.index()];
  // Outside the source's box it ends nothing that is inside.
  if (!blockers_.MakePart(f.owner, part, box)) return;
  cones_.Complete(part.cone);
  BundleSides from;
  BundleSides to;
  geometry_.FilterSides(part.cone.bundle, e.from, from);
  geometry_.FilterSides(part.cone.bundle, e.to, to);
  Cover cover;
  const bool overlaps = CoverOf(geometry_, e, part.cone, from, to, cover);
  if (IsSource() || (f.edge.from != e.to && f.edge.to != e.to)) {
    // The owner's cone meets the plane in the edge alone.
    geometry_.CompleteSides(part.cone.bundle, e.to, to);
    if (to.negative == 0) ends_alone_ = false;
  }
  if (!overlaps || IsSource()) return;
  assert(cover.side != Sign::kZero);
  ++counts_.overlaps;
  if (self_ < other) return;
  jumps_.push_back({cover.begin, 0, 1, ChainEdgeId()});
  jumps_.push_back({cover.end, 0, -1, ChainEdgeId()});
}

/// Deals with an edge that shares an end with the swept one: it crosses it
/// nowhere else, and may lie on it. far: its other end.
template <class Geometry>
void EdgeSweep<Geometry>::TryNeighbour(ChainEdgeId other,
                                       ViewDirectionId shared,
                                       ViewDirectionId far) {
  if (geometry_.PlaneSide(edge_.plane, far).sign == Sign::kZero) {
    AddOverlap(other);
  } else if (IsSource() && shared == edge_.to) {
    ends_alone_ = false;
  }
}

/// Adds where another chain edge crosses the swept one inside the interval, or
/// touches it from the side that is swept.
template <class Geometry>
void EdgeSweep<Geometry>::TryJump(ChainEdgeId other) {
  const ViewEdge& e = edge_;
  const ChainEdge& f = chain_.edges()[other];
  if (IsOwnEnd(f.edge.from)) {
    TryNeighbour(other, f.edge.from, f.edge.to);
    return;
  }
  if (IsOwnEnd(f.edge.to)) {
    TryNeighbour(other, f.edge.to, f.edge.from);
    return;
  }
  const Sign p = geometry_.PlaneSide(e.plane, f.edge.from).sign;
  const Sign q = geometry_.PlaneSide(e.plane, f.edge.to).sign;
  if (p == q && p != Sign::kZero) return;
  if (p == q) {
    AddOverlap(other);
    return;
  }
  const Side u = geometry_.PlaneSide(f.edge.plane, e.from);
  if (u.sign == Sign::kZero) return;
  const Side v = geometry_.PlaneSide(f.edge.plane, e.to);
  if (u.sign == v.sign) return;
  // Where e enters the positive side of f, f leaves that of e; else the two
  // planes meet there in opposite directions.
  const bool enters = u.sign == Sign::kNegative;
  const Sign first = enters ? Sign::kPositive : Sign::kNegative;
  if (p == -first || q == first) return;
  if (v.sign == Sign::kZero) {
    ends_alone_ = false;
    return;
  }
  const Sign swept_side = IsSource() ? Sign::kPositive : Sign::kNegative;
  if (p == Sign::kZero && q != swept_side) return;
  if (q == Sign::kZero && p != swept_side) return;
  const EdgePosition at = MakeCrossing(f.edge.plane, u, v);
  if (!is_whole_ && (!IsBefore(begin_, at) || !IsBefore(at, end_))) return;
  jumps_.push_back({at, enters ? f.coefficient : -f.coefficient, 0, other,
                    first != swept_side, p != Sign::kZero && q != Sign::kZero});
}

template <class Geometry>
void EdgeSweep<Geometry>::Start(const ViewEdge& edge, ChainEdgeId self,
                                const ImageBox& box, const EdgePosition& begin,
                                const EdgePosition& end) {
  edge_ = edge;
  self_ = self;
  begin_ = begin;
  end_ = end;
  is_whole_ = begin.plane == kFromEnd && end.plane == kToEnd;
  ends_alone_ = true;
  jumps_.clear();
  ForEachNear(box, [&](ChainEdgeId other) {
    if (other != self) TryJump(other);
  });
  if (jumps_.size() < 2) return;
  std::ranges::sort(jumps_, [this](const DepthJump& a, const DepthJump& b) {
    return IsBefore(a.at, b.at);
  });
}

template class EdgeSweep<ViewGeometry>;
template class EdgeSweep<UnfilteredViewGeometry>;
template class EdgeSweep<DisplacedViewGeometry>;

}  // namespace truelux
