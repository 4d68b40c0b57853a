// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_cones.h"

#include <cassert>
#include <cstddef>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

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
bool SourceCones<Geometry>::SetSource(int facet) {
  const int first = pieces_.FirstPieceOf(facet);
  assert(cones_.ReceiverSide(first) == Sign::kNegative);
  facet_ = facet;
  parts_.clear();
  boxes_.clear();
  is_source_.Clear();
  plane_.Start(scene_.facets()[Index(facet)].first_triangle);
  const auto count = static_cast<int>(pieces_.PiecesOf(facet).size());
  for (int piece = first; piece < first + count; ++piece) {
    for (const int vertex : pieces_.CornersOf(pieces_.pieces()[Index(piece)])) {
      plane_.MarkInPlane(vertex);
    }
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
bool SourceCones<Geometry>::IsEarlier(int facet) const {
  const auto facets = scene_.facets();
  return facets[Index(facet)].face < facets[Index(facet_)].face;
}

template class SourceCones<ViewGeometry>;
template class SourceCones<UnfilteredViewGeometry>;

}  // namespace truelux
