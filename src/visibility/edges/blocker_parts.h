// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of pieces that can hide some of a source (method.md, section 4).

#ifndef TRUELUX_VISIBILITY_EDGES_BLOCKER_PARTS_H_
#define TRUELUX_VISIBILITY_EDGES_BLOCKER_PARTS_H_

#include <span>
#include <vector>

#include "base/stamped_table.h"
#include "exact/view_geometry.h"
#include "scene/index/convex_pieces.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/part.h"
#include "visibility/edges/part_bins.h"
#include "visibility/edges/part_grid.h"
#include "visibility/edges/source_cones.h"

namespace truelux {

/// Collects the blockers of one source after the other. What a source is and
/// what blocks it are separate steps, so that the blockers can come from any
/// superset of those that matter.
template <class Geometry>
class BlockerParts {
 public:
  /// The arguments must outlive the object.
  BlockerParts(const ConvexPieces& pieces, Geometry& geometry,
               ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
               DirectionSides<Geometry>& sides);

  /// Starts without blockers, after the source has been set. The direction
  /// sides are then those to the source's first cone, and must be so while
  /// blockers are added.
  void Start();

  /// Whether a piece may block the source, by its box; cheap. If so, `box` is
  /// its box.
  bool MayBlock(PieceId piece, ImageBox& box);

  /// Makes the part of a piece that lies in front of the source's plane, above
  /// the horizon or not. box: of the piece before, of the part after. False if
  /// there is none, or if its box does not meet the source's.
  bool MakePart(PieceId piece, Part& part, ImageBox& box);

  /// Whether a cone, whose box is given, contains every cone of the source.
  bool HidesAll(Cone& cone, const ImageBox& box);

  /// Adds a piece that may block the source. Ignores those that cannot hide
  /// any of it, and pieces whose plane contains r. box: from MayBlock.
  void Add(PieceId piece, const ImageBox& box);

  /// Takes out the blockers that lie in the cone of another one; of equal ones
  /// one stays. `bins` hold the blockers' boxes, before and after.
  void DropHidden(PartBins& bins);

  /// The same without bins, for many small blockers; false, and nothing done, if
  /// they are not.
  bool DropHiddenInGrid();

  /// The blockers.
  [[nodiscard]] std::span<Part> parts() { return parts_; }

  /// The boxes of parts(), in their order.
  [[nodiscard]] std::span<const ImageBox> boxes() const { return boxes_; }

  /// Whether one blocker alone certainly hides the whole source.
  [[nodiscard]] bool hide_all() const { return hide_all_; }

  /// Whether a piece blocks the source with any part of it, hidden by other
  /// blockers or not.
  [[nodiscard]] bool IsBlocker(PieceId piece) const {
    return is_blocker_.Contains(piece);
  }

 private:
  bool IsApart(const Cone& cone, const ImageBox& box);
  template <class Finder>
  bool Drop(const Finder& finder);

  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  DirectionSides<Geometry>& sides_;

  std::vector<Part> parts_;
  std::vector<ImageBox> boxes_;
  std::vector<bool> dropped_;  ///< per part, while DropHidden runs
  PartGrid grid_;
  bool hide_all_ = false;
  StampedSet<PieceId> is_blocker_;
};

extern template class BlockerParts<ViewGeometry>;
extern template class BlockerParts<UnfilteredViewGeometry>;
extern template class BlockerParts<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_BLOCKER_PARTS_H_
