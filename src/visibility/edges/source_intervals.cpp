// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_intervals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace truelux {

/// Adds the interval in one cone. On an edge of the source that edge has the
/// arcs; on a diagonal, where both sides are source, the cone on the positive
/// side stands for both. source_sides_: to the cone.
template <class Geometry>
void SourceIntervals<Geometry>::FindInCone(const ViewEdge& edge, Cone& cone) {
  BundleSides& from = source_sides_.Of(edge.from);
  BundleSides& to = source_sides_.Of(edge.to);
  const std::uint32_t all = geometry_.BundleMask(cone.bundle);
  if ((from.positive & to.positive) == all) {
    intervals_.push_back({kEdgeFrom, kEdgeTo});
    return;
  }
  Cover cover;
  if (!CoverOf(geometry_, edge, cone, from, to, cover)) return;
  if (cover.side != Sign::kZero) {
    const bool is_diagonal = source_.IsDiagonal(cone.edges[cover.coincident]);
    if (!is_diagonal || cover.side != Sign::kPositive) return;
    ++on_diagonals_;
  }
  intervals_.push_back({cover.begin, cover.end});
}

template <class Geometry>
bool SourceIntervals<Geometry>::FindByOutline(const ViewEdge& edge,
                                              const ImageBox& box) {
  if (!has_outline_) outline_.SetSource();
  has_outline_ = true;
  return outline_.Clip(edge, box, intervals_);
}

template <class Geometry>
void SourceIntervals<Geometry>::FindInCones(const ViewEdge& edge,
                                            const ImageBox& box) {
  ++touching_;
  outline_.ForEachConeNear(box, [&](Cone& cone) {
    cones_.Complete(cone);
    source_sides_.SetBundle(cone.bundle);
    FindInCone(edge, cone);
    return true;
  });
  if (intervals_.size() > 1) {
    std::ranges::sort(
        intervals_, [&](const EdgeInterval& a, const EdgeInterval& b) {
          return ComparePositions(geometry_, edge, a.begin, b.begin) ==
                 Sign::kNegative;
        });
  }
}

template <class Geometry>
void SourceIntervals<Geometry>::Find(const ViewEdge& edge,
                                     const ImageBox& box) {
  intervals_.clear();
  if (!box.Meets(source_.box())) return;
  if (source_.parts().size() == 1) {
    FindInCone(edge, source_.parts().front().cone);
  } else if (!FindByOutline(edge, box)) {
    intervals_.clear();
    FindInCones(edge, box);
  }
}

template class SourceIntervals<ViewGeometry>;
template class SourceIntervals<UnfilteredViewGeometry>;
template class SourceIntervals<DisplacedViewGeometry>;

}  // namespace truelux
