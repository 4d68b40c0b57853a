// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs between two sources of the same emission add nothing: what one sees of
// them ends where what the other sees begins.

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_JOIN_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_JOIN_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "truelux/scene.h"

#include "scene/index/convex_pieces.h"
#include "scene/scene_access.h"
#include "visibility/edges/source_contour.h"

namespace truelux {

/// Finds equal opposite arcs on the edges that emitting faces share. Exact: an
/// arc is dropped only together with the other one of its pair.
template <class Geometry>
class SourceJoin {
 public:
  /// The arguments must outlive the object.
  SourceJoin(const Scene& scene, const ConvexPieces& pieces,
             const Geometry& geometry)
      : scene_(scene), pieces_(pieces), geometry_(geometry) {}

  /// Sets dropped[i] for each of the arcs of one receiver's sources that goes.
  void FindPairs(const std::vector<ViewArc>& arcs, std::vector<bool>& dropped) {
    dropped.assign(arcs.size(), false);
    open_.clear();
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const EdgeId edge = arcs[i].own_edge;
      if (edge != kNoEdge && IsShared(edge))
        open_.push_back({pieces_.FirstSameEdge(edge), i});
    }
    // Arcs of one edge come together, in their order.
    std::ranges::sort(open_, [](const Open& a, const Open& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.arc < b.arc;
    });
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::size_t first = open_[i].arc;
      if (dropped[first]) continue;
      for (std::size_t k = i + 1;
           k < open_.size() && open_[k].edge == open_[i].edge; ++k) {
        const std::size_t second = open_[k].arc;
        if (!dropped[second] && AreOpposite(arcs[first], arcs[second])) {
          dropped[first] = true;
          dropped[second] = true;
          break;
        }
      }
    }
  }

 private:
  /// An arc on a shared edge.
  struct Open {
    EdgeId edge;  ///< the same for all edges between the same vertices
    std::size_t arc = 0;
  };

  [[nodiscard]] const Rgb& EmissionAt(EdgeId edge) const {
    const Piece& piece = pieces_.pieces()[pieces_.PieceOf(edge)];
    return FacesOf(scene_)[FaceOf(scene_, piece.facet)].emission;
  }

  /// Whether some other piece with this edge emits the same.
  [[nodiscard]] bool IsShared(EdgeId edge) const {
    for (EdgeId other = pieces_.NextSameEdge(edge); other != edge;
         other = pieces_.NextSameEdge(other)) {
      if (EmissionAt(other) == EmissionAt(edge)) return true;
    }
    return false;
  }

  /// Whether two arcs of the same edge cover the same part of it, seen from
  /// its two sides. A source's own edge runs counter-clockwise around it and
  /// shows it on the positive side, so that two opposite ones run through the
  /// edge in opposite directions.
  [[nodiscard]] bool AreOpposite(const ViewArc& a, const ViewArc& b) const {
    return EmissionAt(a.own_edge) == EmissionAt(b.own_edge) &&
           a.piece.positive && b.piece.positive &&
           IsReversed(a.edge.plane, b.edge.plane) &&
           IsSame(a.edge, a.piece.begin, b.edge, b.piece.end) &&
           IsSame(a.edge, a.piece.end, b.edge, b.piece.begin);
  }

  [[nodiscard]] bool IsReversed(ViewPlaneId plane, ViewPlaneId other) const {
    return geometry_.plane(plane).IsReverseOf(geometry_.plane(other));
  }

  [[nodiscard]] bool IsSame(const ViewEdge& edge_a, const EdgePosition& a,
                            const ViewEdge& edge_b,
                            const EdgePosition& b) const {
    if (a.plane.valid() && b.plane.valid()) {
      return geometry_.SameEdge(a.plane, b.plane);
    }
    if (a.plane.valid() || b.plane.valid()) return false;
    return geometry_.direction(End(edge_a, a)) ==
           geometry_.direction(End(edge_b, b));
  }

  static ViewDirectionId End(const ViewEdge& edge,
                             const EdgePosition& position) {
    return position.plane == kFromEnd ? edge.from : edge.to;
  }

  const Scene& scene_;
  const ConvexPieces& pieces_;
  const Geometry& geometry_;
  std::vector<Open> open_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_JOIN_H_
