#include "visibility/arrangement_engine.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "visibility/arrangement_chart.h"
#include "visibility/arrangement_map.h"

namespace truelux {
namespace {

/// What one receiver needs to know of a facet.
struct FacetView {
  bool blocks = false;     ///< takes part: not ignored, not edge-on
  bool is_source = false;  ///< emits to r, and has a point above the horizon
  Vec3<Exact> normal;      ///< points to the front
  Exact height;            ///< normal . (p - r); negative: r is in front
};

bool Emits(const ContourQuery& query, const Facet& facet) {
  if (query.only_source != 0) return facet.face + 1 == query.only_source;
  const Rgb& emission =
      query.scene.faces()[static_cast<std::size_t>(facet.face)].emission;
  return std::any_of(emission.begin(), emission.end(),
                     [](double m) { return m > 0; });
}

std::span<const Triangle> TrianglesOf(const ContourQuery& query,
                                      const Facet& facet) {
  return query.scene.triangles().subspan(
      static_cast<std::size_t>(facet.first_triangle),
      static_cast<std::size_t>(facet.triangle_count));
}

bool HasPointAboveHorizon(const ContourQuery& query, const Facet& facet,
                          const RecipeEvaluator<Exact>& exact) {
  for (const Triangle& triangle : TrianglesOf(query, facet)) {
    for (const int v : triangle.vertices) {
      if (SignOf(exact.AboveHorizon(v)) == Sign::kPositive) return true;
    }
  }
  return false;
}

std::vector<FacetView> FacetViewsOf(const ContourQuery& query) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  const std::vector<bool> ignored = IgnoredFacets(query);
  std::vector<FacetView> views;
  for (const Facet& facet : query.scene.facets()) {
    FacetView view;
    view.normal = exact.TriangleNormal(facet.first_triangle);
    view.height = exact.Height(facet.first_triangle);
    const Sign side = SignOf(view.height);
    view.blocks =
        side != Sign::kZero && (ignored.empty() || !ignored[views.size()]);
    view.is_source = view.blocks && side == Sign::kNegative &&
                     Emits(query, facet) &&
                     HasPointAboveHorizon(query, facet, exact);
    views.push_back(std::move(view));
  }
  return views;
}

/// All facets in a chart, clipped to its cone and cut into triangles; none if
/// no source is among them.
std::vector<ImageTriangle> ImageOf(const ContourQuery& query,
                                   std::span<const FacetView> views,
                                   const ViewChart& chart) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  std::vector<ImageTriangle> image;
  bool has_source = false;
  for (const Triangle& triangle : query.scene.triangles()) {
    const FacetView& view = views[static_cast<std::size_t>(triangle.facet)];
    if (!view.blocks) continue;
    std::array<Vec3<Exact>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = exact.FromReceiver(triangle.vertices[k]);
    }
    std::vector<ImagePoint> polygon;
    for (const WorldPoint& p : chart.Clip(corners)) {
      polygon.push_back(chart.ImageFromWorld(p));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      image.push_back(
          {{polygon[0], polygon[k - 1], polygon[k]}, triangle.facet});
      has_source = has_source || view.is_source;
    }
  }
  if (!has_source) image.clear();
  return image;
}

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
    contour_.explicit_vectors.push_back(std::move(vector));
    return static_cast<int>(contour_.explicit_vectors.size()) - 1;
  }

  int AddDirection(Vec3<Exact> direction) {
    contour_.directions.push_back({.kind = DirectionRecipe::Kind::kExplicit,
                                   .a = AddExplicit(std::move(direction))});
    return static_cast<int>(contour_.directions.size()) - 1;
  }

  const Vec3<Exact>& Direction(int index) const {
    const int entry = contour_.directions[static_cast<std::size_t>(index)].a;
    return contour_.explicit_vectors[static_cast<std::size_t>(entry)];
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
  const std::vector<FacetView> views = FacetViewsOf(query);
  ContourBuilder builder(query, views);
  const bool any_source =
      std::any_of(views.begin(), views.end(),
                  [](const FacetView& view) { return view.is_source; });
  if (any_source) {
    for (const ViewChart& chart : ViewChartsOf(query.receiver.normal)) {
      const std::vector<ImageTriangle> image = ImageOf(query, views, chart);
      if (!image.empty()) builder.Add(chart, FrontMost(image));
    }
  }
  return builder.Build();
}

}  // namespace truelux
