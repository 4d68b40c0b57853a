// SPDX-License-Identifier: GPL-3.0-or-later
// One source seen from one receiver: the cones that it consists of (method.md,
// section 4).

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_CONES_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_CONES_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/scene.h"

#include "base/stamped_table.h"
#include "exact/view_geometry.h"
#include "scene/index/convex_pieces.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/part.h"
#include "visibility/edges/source_plane.h"

namespace truelux {

/// The cones of one source S after the other: those of the pieces of a facet, or
/// of the facets of an EmitterGroup, above the horizon.
template <class Geometry>
class SourceCones {
 public:
  /// The arguments must outlive the object.
  SourceCones(const Scene& scene, const ConvexPieces& pieces,
              Geometry& geometry, ConeMaker<Geometry>& cones);

  /// Chooses the source: a facet, or the facets of an EmitterGroup, which must
  /// live on. False if nothing of it is above the horizon. Requires r strictly
  /// in front of the facets' plane.
  bool SetSource(std::span<const FacetId> facets);

  /// Chooses some of the facets that have been set, those from `first` to
  /// before `end`, as the source: what parts, boxes, box and IsSource are
  /// about. What is known of the plane stays. False if nothing of them is above
  /// the horizon.
  bool Narrow(std::size_t first, std::size_t end);

  /// The pieces of the source above the horizon. Their cones are complete if
  /// the source is a facet; else ConeMaker::Complete has to be called.
  [[nodiscard]] std::span<Part> parts() {
    return std::span(parts_).subspan(first_part_, part_count_);
  }

  /// The boxes of parts(), in their order.
  [[nodiscard]] std::span<const ImageBox> boxes() const {
    return std::span(boxes_).subspan(first_part_, part_count_);
  }

  /// Contains them all.
  [[nodiscard]] const ImageBox& box() const { return box_; }

  /// The source's plane.
  [[nodiscard]] SourcePlane<Geometry>& plane() { return plane_; }

  /// The facets that have been set.
  [[nodiscard]] std::span<const FacetId> facets() const { return facets_; }

  /// Whether a facet is one of those that have been set.
  [[nodiscard]] bool IsOwn(FacetId facet) const {
    return facet == facets_.front() ||
           (facets_.size() > 1 && is_own_.Contains(facet));
  }

  /// Whether a piece is one of parts().
  [[nodiscard]] bool IsSource(PieceId piece) const {
    return is_source_.Contains(piece);
  }

  /// Whether both sides of an edge of the source are source: the pieces on both
  /// its sides survived the horizon.
  [[nodiscard]] bool IsDiagonal(EdgeId edge) const {
    if (edge == kNoEdge) return false;
    for (EdgeId other = pieces_.NextSameEdge(edge); other != edge;
         other = pieces_.NextSameEdge(other)) {
      if (IsSource(pieces_.PieceOf(other))) return true;
    }
    return false;
  }

  /// Whether a facet is known, without arithmetic, to lie in the plane of the
  /// source.
  [[nodiscard]] bool IsCoplanar(FacetId facet) const {
    return pieces_.FirstInPlaneOf(facet) ==
           pieces_.FirstInPlaneOf(facets_.front());
  }

  /// Whether a facet in the plane of the source hides the source where it
  /// overlaps it (coplanar_order.h).
  [[nodiscard]] bool IsSeenBeforeSource(FacetId facet);

 private:
  const Scene& scene_;
  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;

  std::span<const FacetId> facets_;
  StampedSet<FacetId> is_own_;  ///< if there are several
  SourcePlane<Geometry> plane_;
  std::vector<Part> parts_;             ///< of all facets
  std::vector<std::size_t> part_ends_;  ///< of each facet
  std::size_t first_part_ = 0;          ///< of those that are chosen
  std::size_t part_count_ = 0;
  std::vector<ImageBox> boxes_;
  ImageBox box_;
  StampedSet<PieceId> is_source_;
};

extern template class SourceCones<ViewGeometry>;
extern template class SourceCones<UnfilteredViewGeometry>;
extern template class SourceCones<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_CONES_H_
