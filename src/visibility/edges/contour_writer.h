// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs in the view geometry's ids -> a Contour, which holds only the planes
// and directions that its arcs use.

#ifndef TRUELUX_VISIBILITY_EDGES_CONTOUR_WRITER_H_
#define TRUELUX_VISIBILITY_EDGES_CONTOUR_WRITER_H_

#include <span>
#include <utility>

#include "base/id_vector.h"
#include "scene/scene_access.h"
#include "visibility/contour.h"
#include "visibility/edges/source_contour.h"

namespace truelux {

/// Writes the arcs of one receiver's sources, source by source.
template <class Geometry>
class ContourWriter {
 public:
  /// The arguments must outlive the object.
  ContourWriter(const Scene& scene, const ConvexPieces& pieces,
                const Geometry& geometry)
      : scene_(scene), pieces_(pieces), geometry_(geometry) {}

  /// Starts with an empty contour, which must stay where it is.
  void Start(Contour& contour) {
    contour.planes.clear();
    contour.directions.clear();
    contour.explicit_vectors.Clear();
    contour.arcs.clear();
    contour.sources.clear();
    contour.statistics = {};
    contour_ = &contour;
    plane_index_.clear();
    direction_index_.clear();
  }

  void WriteSource(FacetId facet, std::span<const ViewArc> arcs) {
    if (arcs.empty()) return;
    plane_index_.resize(geometry_.plane_count());
    direction_index_.resize(geometry_.direction_count());
    contour_->sources.push_back(
        {facet, contour_->arcs.end_id(), static_cast<int>(arcs.size())});
    for (const ViewArc& arc : arcs)
      WriteArc(arc);
  }

 private:
  void WriteArc(const ViewArc& view_arc) {
    Arc arc;
    arc.plane = PlaneIndex(view_arc.edge.plane);
    arc.positive = view_arc.piece.positive;
    arc.from = Position(view_arc.edge, view_arc.piece.begin);
    arc.to = Position(view_arc.edge, view_arc.piece.end);
    if (!arc.positive) std::swap(arc.from, arc.to);
    if (view_arc.owner.valid()) {
      const FacetId facet = pieces_.pieces()[view_arc.owner].facet;
      arc.edge_face = NumberOf(FaceOf(scene_, facet));
    }
    contour_->arcs.push_back(arc);
  }

  DirectionId Position(const ViewEdge& edge, const EdgePosition& position) {
    if (position.plane == kFromEnd) return DirectionIndex(edge.from);
    if (position.plane == kToEnd) return DirectionIndex(edge.to);
    // With N a positive multiple of u x v, N x A is one of (A.u) v - (A.v) u,
    // which points between u and v if A.u > 0 > A.v, else away from there.
    const PlaneId own = PlaneIndex(edge.plane);
    return contour_->directions.push_back(
        DirectionRecipe::Crossing(own, PlaneIndex(position.plane))
            .NegatedIf(position.from == Sign::kNegative));
  }

  PlaneId PlaneIndex(ViewPlaneId id) {
    PlaneId& index = plane_index_[id];
    if (!index.valid()) index = contour_->planes.push_back(geometry_.plane(id));
    return index;
  }

  DirectionId DirectionIndex(ViewDirectionId id) {
    DirectionId& index = direction_index_[id];
    if (!index.valid()) {
      index = contour_->directions.push_back(geometry_.direction(id));
    }
    return index;
  }

  const Scene& scene_;
  const ConvexPieces& pieces_;
  const Geometry& geometry_;
  Contour* contour_ = nullptr;
  IdVector<ViewPlaneId, PlaneId> plane_index_;  ///< in contour_, or none
  IdVector<ViewDirectionId, DirectionId> direction_index_;  ///< likewise
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_CONTOUR_WRITER_H_
