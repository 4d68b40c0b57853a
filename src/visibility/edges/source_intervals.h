// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_INTERVALS_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_INTERVALS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/source_cones.h"
#include "visibility/edges/source_outline.h"

namespace truelux {

/// Finds where edges run inside the source: those of blockers, or of their
/// chain. Allocates nothing in the steady state.
template <class Geometry>
class SourceIntervals {
 public:
  /// source_sides: to the first cone of the source while Find is called. The
  /// arguments must outlive the object.
  SourceIntervals(Geometry& geometry, ConeMaker<Geometry>& cones,
                  SourceCones<Geometry>& source,
                  DirectionSides<Geometry>& source_sides)
      : geometry_(geometry),
        cones_(cones),
        source_(source),
        source_sides_(source_sides),
        outline_(geometry, cones, source) {}

  /// Starts with the source that has been set or narrowed.
  void SetSource() { has_outline_ = false; }

  /// Finds the intervals of an edge, in order. They do not overlap. Along an
  /// edge of the source there are none; along a diagonal there are.
  /// box: the edge's.
  void Find(const ViewEdge& edge, const ImageBox& box);

  [[nodiscard]] std::span<const EdgeInterval> intervals() const {
    return intervals_;
  }

  /// How many intervals along diagonals have been found.
  [[nodiscard]] std::uint64_t on_diagonals() const { return on_diagonals_; }

  /// For how many edges the cones had to be asked, since they touch the outline
  /// of a source of several cones.
  [[nodiscard]] std::uint64_t touching() const { return touching_; }

 private:
  void FindInCone(const ViewEdge& edge, Cone& cone);
  bool FindByOutline(const ViewEdge& edge, const ImageBox& box);
  void FindInCones(const ViewEdge& edge, const ImageBox& box);

  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  DirectionSides<Geometry>& source_sides_;
  SourceOutline<Geometry> outline_;  ///< of a source of several cones
  bool has_outline_ = false;         ///< made at the first edge that needs it
  std::vector<EdgeInterval> intervals_;
  std::uint64_t on_diagonals_ = 0;
  std::uint64_t touching_ = 0;
};

extern template class SourceIntervals<ViewGeometry>;
extern template class SourceIntervals<UnfilteredViewGeometry>;
extern template class SourceIntervals<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_INTERVALS_H_
