// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_cones.h"

#include <cassert>

#include "scene/coplanar_order.h"
#include "scene/scene_access.h"

namespace truelux {

template <class Geometry>
SourceCones<Geometry>::SourceCones(const Scene& scene,
                                   const ConvexPieces& pieces,
                                   Geometry& geometry,
                                   ConeMaker<Geometry>& cones)
    : scene_(scene),
      pieces_(pieces),
      geometry_(geometry),
      cones_(cones),
      is_own_(FacetsOf(scene).size()),
      plane_(geometry),
      is_source_(pieces.pieces().size()) {}

template <class Geometry>
bool SourceCones<Geometry>::SetSource(std::span<const FacetId> facets) {
  const FacetId first = facets.front();
  assert(cones_.ReceiverSide(pieces_.FirstPieceOf(first)) == Sign::kNegative);
  facets_ = facets;
  const bool is_group = facets.size() > 1;
  parts_.clear();
  boxes_.clear();
  part_ends_.clear();
  if (is_group) is_own_.Clear();
  plane_.Start(FirstTriangleOf(FacetsOf(scene_)[first]));
  for (const FacetId facet : facets) {
    if (is_group) is_own_.Insert(facet);
    for (const PieceId piece : pieces_.PiecesOf(facet)) {
      for (const VertexId vertex : pieces_.CornersOf(piece))
        plane_.MarkInPlane(vertex);
      if (auto cone = cones_.AboveHorizon(piece)) {
        if (!is_group) cones_.Complete(*cone);
        parts_.push_back({*cone, {}});
        boxes_.push_back(plane_.BoxOf(*cone));
      }
    }
    part_ends_.push_back(parts_.size());
  }
  return Narrow(0, facets.size());
}

template <class Geometry>
bool SourceCones<Geometry>::Narrow(std::size_t first, std::size_t end) {
  first_part_ = first > 0 ? part_ends_[first - 1] : 0;
  part_count_ = part_ends_[end - 1] - first_part_;
  is_source_.Clear();
  if (part_count_ == 0) return false;
  for (const Part& part : parts())
    is_source_.Insert(part.cone.piece);
  box_ = boxes().front();
  for (const ImageBox& box : boxes())
    box_.Include(box);
  return true;
}

template <class Geometry>
bool SourceCones<Geometry>::IsSeenBeforeSource(FacetId facet) {
  const bool shows_front =
      cones_.ReceiverSide(pieces_.FirstPieceOf(facet)) == Sign::kNegative;
  return IsSeenBefore(scene_, {facet, shows_front}, {facets_.front(), true});
}

template class SourceCones<ViewGeometry>;
template class SourceCones<UnfilteredViewGeometry>;
template class SourceCones<DisplacedViewGeometry>;

}  // namespace truelux
