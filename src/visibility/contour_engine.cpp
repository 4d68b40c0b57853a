#include "visibility/contour_engine.h"

#include <algorithm>
#include <unordered_map>

#include "visibility/cone.h"
#include "visibility/source_contour.h"

namespace truelux {
namespace {

/// Moves arcs from the view geometry's ids into a Contour, which holds only
/// the planes and directions that its arcs use.
class ContourWriter {
 public:
  ContourWriter(const Scene& scene, const ViewGeometry& geometry,
                Contour& contour)
      : scene_(scene), geometry_(geometry), contour_(contour) {}

  void WriteSource(int facet, const std::vector<ViewArc>& arcs) {
    if (arcs.empty()) return;
    contour_.sources.push_back({facet, static_cast<int>(contour_.arcs.size()),
                                static_cast<int>(arcs.size())});
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
    if (view_arc.triangle >= 0) {
      const auto facet = static_cast<std::size_t>(
          scene_.triangles()[static_cast<std::size_t>(view_arc.triangle)]
              .facet);
      arc.edge_face = scene_.facets()[facet].face + 1;
    }
    contour_.arcs.push_back(arc);
  }

  int Position(const ViewEdge& edge, const EdgePosition& position) {
    if (position.kind == EdgePosition::Kind::kFrom) {
      return DirectionIndex(edge.from);
    }
    if (position.kind == EdgePosition::Kind::kTo) {
      return DirectionIndex(edge.to);
    }
    // With N a positive multiple of u x v, N x A is one of (A.u) v - (A.v) u,
    // which points between u and v if A.u > 0 > A.v, else away from there.
    contour_.directions.push_back(
        {.kind = DirectionRecipe::Kind::kCrossing,
         .negated = position.crossing.from.sign == Sign::kNegative,
         .a = PlaneIndex(edge.plane),
         .b = PlaneIndex(position.crossing.plane)});
    return static_cast<int>(contour_.directions.size()) - 1;
  }

  int PlaneIndex(int id) {
    const auto [entry, is_new] =
        plane_index_.try_emplace(id, static_cast<int>(contour_.planes.size()));
    if (is_new) contour_.planes.push_back(geometry_.plane(id));
    return entry->second;
  }

  int DirectionIndex(int id) {
    const auto [entry, is_new] = direction_index_.try_emplace(
        id, static_cast<int>(contour_.directions.size()));
    if (is_new) contour_.directions.push_back(geometry_.direction(id));
    return entry->second;
  }

  const Scene& scene_;
  const ViewGeometry& geometry_;
  Contour& contour_;
  std::unordered_map<int, int> plane_index_;
  std::unordered_map<int, int> direction_index_;
};

bool Emits(const Face& face) {
  return std::ranges::any_of(face.emission, [](double m) { return m > 0; });
}

}  // namespace

ContourEngine::ContourEngine(const Scene& scene)
    : triangle_normals_(
          FilteredTriangleNormals(scene.vertices(), scene.triangles())) {}

Contour ContourEngine::Build(const ContourQuery& query) const {
  const Scene& scene = query.scene;
  const std::vector<bool> ignored = IgnoredFacets(query);
  const RoundUpward rounding;
  ViewGeometry geometry(ViewOf(query), triangle_normals_);
  ConeMaker cones(geometry, scene.triangles());
  SourceContour source(scene, geometry, cones);
  Contour contour;
  ContourWriter writer(scene, geometry, contour);

  const auto facets = scene.facets();
  const auto is_ignored = [&ignored](std::size_t facet) {
    return !ignored.empty() && ignored[facet];
  };
  std::uint64_t sources = 0;
  std::uint64_t blockers = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const int face = facets[f].face;
    const bool wanted =
        query.only_source == 0
            ? Emits(scene.faces()[static_cast<std::size_t>(face)])
            : face + 1 == query.only_source;
    if (!wanted || is_ignored(f) ||
        cones.ReceiverSide(facets[f].first_triangle) != Sign::kNegative ||
        !source.SetSource(static_cast<int>(f))) {
      continue;
    }
    ++sources;
    for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
      if (source.Hidden()) break;
      const auto facet = static_cast<std::size_t>(scene.triangles()[t].facet);
      if (is_ignored(facet)) continue;
      const int triangle = static_cast<int>(t);
      if (cones.ReceiverSide(triangle) == Sign::kZero) continue;
      source.AddBlocker(triangle);
    }
    blockers += source.blockers();
    writer.WriteSource(static_cast<int>(f), source.Arcs());
  }
  contour.statistics = geometry.statistics();
  contour.statistics.sources = sources;
  contour.statistics.blockers = blockers;
  contour.statistics.arcs = contour.arcs.size();
  return contour;
}

}  // namespace truelux
