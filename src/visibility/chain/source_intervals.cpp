// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain/source_intervals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace truelux {
namespace {

/// With fewer cones of the source, to look at the boxes of all is faster than
/// sets of bits.
constexpr std::size_t kManyCones = 16;

}  // namespace

template <class Geometry>
void SourceIntervals<Geometry>::SetSource() {
  if (source_.boxes().size() >= kManyCones)
    bins_.Build(source_.boxes(), source_.box());
}

/// Calls visit(index) for the source's cones whose boxes meet a box.
template <class Geometry>
template <class Visit>
void SourceIntervals<Geometry>::ForEachConeNear(const ImageBox& box,
                                                const Visit& visit) {
  const auto boxes = source_.boxes();
  const auto try_cone = [&](std::size_t s) {
    if (boxes[s].Meets(box)) visit(s);
    return true;
  };
  if (boxes.size() < kManyCones) {
    for (std::size_t s = 0; s < boxes.size(); ++s)
      try_cone(s);
  } else {
    bins_.ForEach(box, try_cone);
  }
}

/// On an edge of the source that edge has the arcs; on a diagonal, where both
/// sides are source, the cone on the positive side stands for both.
template <class Geometry>
void SourceIntervals<Geometry>::Find(const ViewEdge& edge) {
  intervals_.clear();
  const auto parts = source_.parts();
  const ImageBox box = source_.plane().BoxOfEdge(edge.from, edge.to);
  ForEachConeNear(box, [&](std::size_t s) {
    Part& part = parts[s];
    cones_.Complete(part.cone);
    if (parts.size() > 1) source_sides_.SetBundle(part.cone.bundle);
    BundleSides& from = source_sides_.Of(edge.from);
    BundleSides& to = source_sides_.Of(edge.to);
    const std::uint32_t all = geometry_.BundleMask(part.cone.bundle);
    if ((from.positive & to.positive) == all) {
      intervals_.push_back({kEdgeFrom, kEdgeTo});
      return;
    }
    Cover cover;
    if (!CoverOf(geometry_, edge, part.cone, from, to, cover)) return;
    if (cover.side != Sign::kZero) {
      const bool is_diagonal =
          source_.IsDiagonal(part.cone.edges[cover.coincident]);
      if (!is_diagonal || cover.side != Sign::kPositive) return;
      ++counts_.diagonals;
    }
    intervals_.push_back({cover.begin, cover.end});
  });
  if (intervals_.size() > 1) {
    std::ranges::sort(
        intervals_, [&](const EdgeInterval& a, const EdgeInterval& b) {
          return ComparePositions(geometry_, edge, a.begin, b.begin) ==
                 Sign::kNegative;
        });
  }
}

template class SourceIntervals<ViewGeometry>;
template class SourceIntervals<UnfilteredViewGeometry>;
template class SourceIntervals<DisplacedViewGeometry>;

}  // namespace truelux
