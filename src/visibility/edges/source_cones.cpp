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
      plane_(geometry),
      is_source_(pieces.pieces().size()) {}

template <class Geometry>
bool SourceCones<Geometry>::SetSource(FacetId facet) {
  assert(cones_.ReceiverSide(pieces_.FirstPieceOf(facet)) == Sign::kNegative);
  facet_ = facet;
  parts_.clear();
  boxes_.clear();
  is_source_.Clear();
  plane_.Start(FirstTriangleOf(FacetsOf(scene_)[facet]));
  for (const PieceId piece : pieces_.PiecesOf(facet)) {
    for (const VertexId vertex : pieces_.CornersOf(piece))
      plane_.MarkInPlane(vertex);
    if (auto cone = cones_.AboveHorizon(piece)) {
      cones_.Complete(*cone);
      parts_.push_back({*cone, {}});
      is_source_.Insert(piece);
    }
  }
  if (parts_.empty()) return false;
  for (const Part& part : parts_)
    boxes_.push_back(plane_.BoxOf(part.cone));
  box_ = boxes_.front();
  for (const ImageBox& box : boxes_)
    box_.Include(box);
  return true;
}

template <class Geometry>
bool SourceCones<Geometry>::IsSeenBeforeSource(FacetId facet) {
  const bool shows_front =
      cones_.ReceiverSide(pieces_.FirstPieceOf(facet)) == Sign::kNegative;
  return IsSeenBefore(scene_, {facet, shows_front}, {facet_, true});
}

template class SourceCones<ViewGeometry>;
template class SourceCones<UnfilteredViewGeometry>;
template class SourceCones<DisplacedViewGeometry>;

}  // namespace truelux
