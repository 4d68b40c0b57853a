// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_CHAIN_SOURCE_INTERVALS_H_
#define TRUELUX_VISIBILITY_CHAIN_SOURCE_INTERVALS_H_

#include <span>
#include <vector>

#include "visibility/chain/chain_counts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/part_bins.h"
#include "visibility/edges/source_cones.h"

namespace truelux {

/// An interval of an edge, not empty.
struct EdgeInterval {
  EdgePosition begin;
  EdgePosition end;
};

/// Finds where edges of the chain run inside the source. Allocates nothing in
/// the steady state.
template <class Geometry>
class SourceIntervals {
 public:
  /// source_sides: to the first cone of the source while Find is called. The
  /// arguments must outlive the object.
  SourceIntervals(Geometry& geometry, ConeMaker<Geometry>& cones,
                  SourceCones<Geometry>& source,
                  DirectionSides<Geometry>& source_sides, ChainCounts& counts)
      : geometry_(geometry),
        cones_(cones),
        source_(source),
        source_sides_(source_sides),
        counts_(counts) {}

  /// Starts with the source that has been set or narrowed.
  void SetSource();

  /// Finds the intervals of an edge, in order. They do not overlap.
  void Find(const ViewEdge& edge);

  [[nodiscard]] std::span<const EdgeInterval> intervals() const {
    return intervals_;
  }

 private:
  template <class Visit>
  void ForEachConeNear(const ImageBox& box, const Visit& visit);

  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  DirectionSides<Geometry>& source_sides_;
  ChainCounts& counts_;
  PartBins bins_;  ///< of a source of many cones
  std::vector<EdgeInterval> intervals_;
};

extern template class SourceIntervals<ViewGeometry>;
extern template class SourceIntervals<UnfilteredViewGeometry>;
extern template class SourceIntervals<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_SOURCE_INTERVALS_H_
