// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_CHAIN_EDGE_SWEEP_H_
#define TRUELUX_VISIBILITY_CHAIN_EDGE_SWEEP_H_

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "visibility/chain/chain_counts.h"
#include "visibility/chain/source_chain.h"
#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/part_bins.h"

namespace truelux {

/// Where the depth changes along an edge.
struct DepthJump {
  EdgePosition at;
  int change = 0;    ///< of the depth on the side that is swept
  int earlier = 0;   ///< of the number of edges that own arcs before this one
  ChainEdgeId edge;  ///< that crosses; none where one begins to overlap
  bool leaves = false;     ///< the edge that crosses goes to the swept side
  bool is_proper = false;  ///< it crosses from side to side
};

/// How the depth changes along one edge after the other, on one side of it: of
/// an edge of the source on the positive side, where the source lies; of a
/// chain edge on the negative one, the less deep. Allocates nothing in the
/// steady state.
template <class Geometry>
class EdgeSweep {
 public:
  /// The arguments must outlive the object.
  EdgeSweep(Geometry& geometry, ConeMaker<Geometry>& cones,
            BlockerParts<Geometry>& blockers,
            const SourceChain<Geometry>& chain, ChainCounts& counts)
      : geometry_(geometry),
        cones_(cones),
        blockers_(blockers),
        chain_(chain),
        counts_(counts) {}

  /// Starts with another chain. frame: the source's box.
  void SetChain(const ImageBox& frame) { bins_.Build(chain_.boxes(), frame); }

  /// Calls visit(ChainEdgeId) for the edges whose boxes meet a box.
  template <class Visit>
  void ForEachNear(const ImageBox& box, const Visit& visit) const {
    bins_.ForEach(box, [&](std::size_t i) {
      if (chain_.boxes()[i].Meets(box)) visit(EndId<ChainEdgeId>(i));
      return true;
    });
  }

  /// Finds the jumps along an edge from `begin` to `end`. self: the chain edge
  /// that it is; none for an edge of the source. box: the edge's.
  void Start(const ViewEdge& edge, ChainEdgeId self, const ImageBox& box,
             const EdgePosition& begin, const EdgePosition& end);

  /// The jumps in their order; those of overlaps may lie outside the interval.
  [[nodiscard]] std::span<const DepthJump> jumps() const { return jumps_; }

  /// Whether no chain edge passes through the far end of the edge or ends
  /// there, except those that share it by its id with a chain edge.
  [[nodiscard]] bool ends_alone() const { return ends_alone_; }

  /// Calls visit(begin, depth, earlier) for every stretch between jumps, and
  /// crossed(jump, depth) for those that are alone in their place; there depth
  /// is the lesser one of those before and after. depth: at the begin. Returns
  /// the depth before the end.
  template <class Visit, class Crossed>
  [[nodiscard]] int ForEachStretch(int depth, const Visit& visit,
                                   const Crossed& crossed) const;

  /// Whether position a comes before position b.
  [[nodiscard]] bool IsBefore(const EdgePosition& a,
                              const EdgePosition& b) const {
    return ComparePositions(geometry_, edge_, a, b) == Sign::kNegative;
  }

 private:
  [[nodiscard]] bool IsSource() const { return !self_.valid(); }

  /// Whether the swept edge begins or ends in a direction.
  [[nodiscard]] bool IsOwnEnd(ViewDirectionId direction) const {
    return direction == edge_.from || edge_.to == direction;
  }

  void TryJump(ChainEdgeId other);
  void TryNeighbour(ChainEdgeId other, ViewDirectionId shared,
                    ViewDirectionId far);
  void AddOverlap(ChainEdgeId other);

  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  BlockerParts<Geometry>& blockers_;
  const SourceChain<Geometry>& chain_;
  ChainCounts& counts_;
  PartBins bins_;

  // Of the edge.
  ViewEdge edge_;
  ChainEdgeId self_;
  EdgePosition begin_;
  EdgePosition end_;
  bool is_whole_ = false;
  bool ends_alone_ = true;
  std::vector<DepthJump> jumps_;
};

template <class Geometry>
template <class Visit, class Crossed>
int EdgeSweep<Geometry>::ForEachStretch(int depth, const Visit& visit,
                                        const Crossed& crossed) const {
  int earlier = 0;
  EdgePosition from = begin_;
  for (std::size_t j = 0; j < jumps_.size();) {
    // Overlaps may begin before the interval and end behind it.
    const EdgePosition at = jumps_[j].at;
    if (IsBefore(from, at)) {
      if (!IsBefore(at, end_)) break;
      visit(from, depth, earlier);
      from = at;
    }
    const int depth_before = depth;
    const std::size_t first = j;
    do {
      depth += jumps_[j].change;
      earlier += jumps_[j].earlier;
      ++j;
    } while (j < jumps_.size() && !IsBefore(at, jumps_[j].at));
    if (j == first + 1) crossed(jumps_[first], std::min(depth_before, depth));
  }
  visit(from, depth, earlier);
  return depth;
}

extern template class EdgeSweep<ViewGeometry>;
extern template class EdgeSweep<UnfilteredViewGeometry>;
extern template class EdgeSweep<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_EDGE_SWEEP_H_
