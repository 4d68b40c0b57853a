#include "visibility/arrangement/arrangement_engine.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "visibility/arrangement/arrangement_view.h"

namespace truelux {
namespace {

/// Gathers the arcs of all charts, source by source.
class ContourBuilder {
 public:
  ContourBuilder(const ContourQuery& query, std::span<const FacetView> views)
      : query_(query), views_(views), arcs_of_facet_(views.size()) {}

  void Add(const ViewChart& chart, const ViewMap& map) {
    std::vector<int> direction_of(map.vertices.size(), -1);
    const auto direction = [&](int vertex) {
      int& index = direction_of[static_cast<std::size_t>(vertex)];
      if (index < 0) {
        index = AddDirection(chart.WorldFromImage(
            map.vertices[static_cast<std::size_t>(vertex)]));
      }
      return index;
    };
    for (const MapEdge& edge : map.edges) {
      if (!IsSource(edge.left) && !IsSource(edge.right)) continue;
      const bool on_wall =
          OnWall(map.vertices[static_cast<std::size_t>(edge.from)],
                 map.vertices[static_cast<std::size_t>(edge.to)]);
      AddEdge(direction(edge.from), direction(edge.to), edge, on_wall);
    }
  }

  Contour Build() {
    for (std::size_t f = 0; f < views_.size(); ++f) {
      if (views_[f].is_source) ++contour_.statistics.sources;
      const std::vector<Arc>& arcs = arcs_of_facet_[f];
      if (arcs.empty()) continue;
      contour_.sources.push_back({static_cast<int>(f),
                                  static_cast<int>(contour_.arcs.size()),
                                  static_cast<int>(arcs.size())});
      contour_.arcs.insert(contour_.arcs.end(), arcs.begin(), arcs.end());
    }
    contour_.statistics.arcs = contour_.arcs.size();
    return std::move(contour_);
  }

 private:
  const FacetView& View(int facet) const {
    return views_[static_cast<std::size_t>(facet)];
  }

  bool IsSource(int facet) const { return facet >= 0 && View(facet).is_source; }

  static bool OnWall(const ImageDirection& a, const ImageDirection& b) {
    return (ViewChart::OnHorizon(a) && ViewChart::OnHorizon(b)) ||
           (ViewChart::OnCutA(a) && ViewChart::OnCutA(b)) ||
           (ViewChart::OnCutB(a) && ViewChart::OnCutB(b));
  }

  int AddExplicit(Vec3<Exact> vector) {
    return contour_.explicit_vectors.Add(std::move(vector));
  }

  int AddDirection(Vec3<Exact> direction) {
    contour_.directions.push_back({.kind = DirectionRecipe::Kind::kExplicit,
                                   .a = AddExplicit(std::move(direction))});
    return static_cast<int>(contour_.directions.size()) - 1;
  }

  const Vec3<Exact>& Direction(int index) const {
    const int entry = contour_.directions[static_cast<std::size_t>(index)].a;
    return contour_.explicit_vectors[entry];
  }

  void AddEdge(int from, int to, const MapEdge& edge, bool on_wall) {
    const int plane = static_cast<int>(contour_.planes.size());
    contour_.planes.push_back(
        {.kind = PlaneRecipe::Kind::kExplicit,
         .a = AddExplicit(Cross(Direction(from), Direction(to)))});
    // The plane's normal points to the left of from -> to.
    if (IsSource(edge.left)) {
      const int face = on_wall ? 0 : EdgeFace(edge.left, edge.right, from, to);
      ArcsOf(edge.left).push_back({plane, true, from, to, face});
    }
    if (IsSource(edge.right)) {
      const int face = on_wall ? 0 : EdgeFace(edge.right, edge.left, from, to);
      ArcsOf(edge.right).push_back({plane, false, to, from, face});
    }
  }

  std::vector<Arc>& ArcsOf(int facet) {
    return arcs_of_facet_[static_cast<std::size_t>(facet)];
  }

  int FaceNumber(int facet) const {
    return query_.scene.facets()[static_cast<std::size_t>(facet)].face + 1;
  }

  /// The face whose edge separates a source from its neighbour in the view:
  /// the nearer of the two, because it ends there. Where both are equally near
  /// all along, the neighbour enters the source's plane; if they are coplanar,
  /// the one in front ends there.
  int EdgeFace(int source, int neighbour, int from, int to) const {
    if (neighbour < 0) return FaceNumber(source);
    const FacetView& own = View(source);
    const FacetView& other = View(neighbour);
    for (const int end : {from, to}) {
      // normal . d / height is |d| / distance along d, positive for both.
      const Vec3<Exact>& d = Direction(end);
      const Sign nearer = SignOf(Dot(own.normal, d) * other.height -
                                 Dot(other.normal, d) * own.height) *
                          SignOf(own.height) * SignOf(other.height);
      if (nearer == Sign::kPositive) return FaceNumber(source);
      if (nearer == Sign::kNegative) return FaceNumber(neighbour);
    }
    const Vec3<Exact> line = Cross(own.normal, other.normal);
    const bool coplanar =
        line.x.is_zero() && line.y.is_zero() && line.z.is_zero();
    return FaceNumber(coplanar ? std::min(source, neighbour) : neighbour);
  }

  const ContourQuery& query_;
  std::span<const FacetView> views_;
  std::vector<std::vector<Arc>> arcs_of_facet_;
  Contour contour_;
};

}  // namespace

Contour ContourByArrangement(const ContourQuery& query) {
  const std::vector<FacetView> facets = FacetViewsOf(query);
  return ContourByArrangement(query, facets, ChartViewsOf(query, facets));
}

Contour ContourByArrangement(const ContourQuery& query,
                             std::span<const FacetView> facets,
                             std::span<const ChartView> charts) {
  ContourBuilder builder(query, facets);
  for (const ChartView& view : charts)
    builder.Add(view.chart, view.map);
  return builder.Build();
}

}  // namespace truelux
