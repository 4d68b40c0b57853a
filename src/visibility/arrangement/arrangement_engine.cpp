// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_engine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/scene_access.h"
#include "visibility/arrangement/arrangement_view.h"

namespace truelux {
namespace {

/// Gathers the arcs of all charts, source by source.
class ContourBuilder {
 public:
  ContourBuilder(const ContourQuery& query, FacetViews views)
      : query_(query), views_(views), arcs_of_facet_(views.size()) {}

  void Add(const ViewChart& chart, const ViewMap& map) {
    IdVector<MapVertexId, DirectionId> direction_of(map.vertices.size());
    const auto direction = [&](MapVertexId vertex) {
      DirectionId& id = direction_of[vertex];
      if (!id.valid())
        id = AddDirection(chart.WorldFromImage(map.vertices[vertex]));
      return id;
    };
    for (const MapEdge& edge : map.edges) {
      if (!IsSource(edge.left) && !IsSource(edge.right)) continue;
      const bool on_wall =
          OnWall(map.vertices[edge.from], map.vertices[edge.to]);
      AddEdge(direction(edge.from), direction(edge.to), edge, on_wall);
    }
  }

  Contour Build() {
    for (const FacetId facet : views_.ids()) {
      if (views_[facet].is_source) ++contour_.statistics.sources;
      const std::vector<Arc>& arcs = arcs_of_facet_[facet];
      if (arcs.empty()) continue;
      contour_.sources.push_back(
          {facet, contour_.arcs.end_id(), static_cast<int>(arcs.size())});
      contour_.arcs.Append(arcs);
    }
    contour_.statistics.arcs = contour_.arcs.size();
    return std::move(contour_);
  }

 private:
  [[nodiscard]] bool IsSource(FacetId facet) const {
    return facet.valid() && views_[facet].is_source;
  }

  static bool OnWall(const ImageDirection& a, const ImageDirection& b) {
    return (ViewChart::OnHorizon(a) && ViewChart::OnHorizon(b)) ||
           (ViewChart::OnCutA(a) && ViewChart::OnCutA(b)) ||
           (ViewChart::OnCutB(a) && ViewChart::OnCutB(b));
  }

  ExplicitId AddExplicit(Vec3<Exact> vector) {
    return contour_.explicit_vectors.Add(std::move(vector));
  }

  DirectionId AddDirection(Vec3<Exact> direction) {
    return contour_.directions.push_back(
        DirectionRecipe::Explicit(AddExplicit(std::move(direction))));
  }

  [[nodiscard]] const Vec3<Exact>& Direction(DirectionId id) const {
    return contour_.explicit_vectors[contour_.directions[id].explicit_vector()];
  }

  void AddEdge(DirectionId from, DirectionId to, const MapEdge& edge,
               bool on_wall) {
    const PlaneId plane = contour_.planes.push_back(PlaneRecipe::Explicit(
        AddExplicit(Cross(Direction(from), Direction(to)))));
    // The plane's normal points to the left of from -> to.
    if (IsSource(edge.left)) {
      const FaceNumber face =
          on_wall ? FaceNumber() : EdgeFace(edge.left, edge.right, from, to);
      arcs_of_facet_[edge.left].push_back({plane, true, from, to, face});
    }
    if (IsSource(edge.right)) {
      const FaceNumber face =
          on_wall ? FaceNumber() : EdgeFace(edge.right, edge.left, from, to);
      arcs_of_facet_[edge.right].push_back({plane, false, to, from, face});
    }
  }

  [[nodiscard]] FaceNumber NumberOfFaceOf(FacetId facet) const {
    return NumberOf(FaceOf(query_.scene, facet));
  }

  /// The face whose edge separates a source from its neighbour in the view:
  /// the nearer of the two, because it ends there. Where both are equally near
  /// all along, the neighbour enters the source's plane; if they are coplanar,
  /// the one that is seen before the other ends there.
  [[nodiscard]] FaceNumber EdgeFace(FacetId source, FacetId neighbour,
                                    DirectionId from, DirectionId to) const {
    if (!neighbour.valid()) return NumberOfFaceOf(source);
    const FacetView& own = views_[source];
    const FacetView& other = views_[neighbour];
    for (const DirectionId end : {from, to}) {
      // normal . d / height is |d| / distance along d, positive for both.
      const Vec3<Exact>& d = Direction(end);
      const Sign nearer = SignOf(Dot(own.normal, d) * other.height -
                                 Dot(other.normal, d) * own.height) *
                          SignOf(own.height) * SignOf(other.height);
      if (nearer == Sign::kPositive) return NumberOfFaceOf(source);
      if (nearer == Sign::kNegative) return NumberOfFaceOf(neighbour);
    }
    const bool coplanar = IsZero(Cross(own.normal, other.normal));
    const bool source_ends =
        coplanar &&
        IsSeenBefore(query_.scene, own.Seen(source), other.Seen(neighbour));
    return NumberOfFaceOf(source_ends ? source : neighbour);
  }

  const ContourQuery& query_;
  FacetViews views_;
  IdVector<FacetId, std::vector<Arc>> arcs_of_facet_;
  Contour contour_;
};

}  // namespace

Contour ContourByArrangement(const ContourQuery& query) {
  const IdVector<FacetId, FacetView> facets = FacetViewsOf(query);
  return ContourByArrangement(query, facets, ChartViewsOf(query, facets));
}

Contour ContourByArrangement(const ContourQuery& query, FacetViews facets,
                             std::span<const ChartView> charts) {
  ContourBuilder builder(query, facets);
  for (const ChartView& view : charts)
    builder.Add(view.chart, view.map);
  return builder.Build();
}

}  // namespace truelux
