// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/angular_spans.h"

#include <algorithm>
#include <utility>

#include "visibility/arrangement/arrangement_view.h"

namespace truelux {
namespace {

/// Reads the span lists of one chart.
class SpanReader {
 public:
  SpanReader(const ChartView& view, FacetViews facets)
      : map_(view.map), facets_(facets) {
    directions_.reserve(map_.vertices.size());
    for (const ImageDirection& vertex : map_.vertices) {
      directions_.push_back(view.chart.WorldFromImage(vertex));
    }
  }

  /// Adds the vertices at which a source is seen.
  void AppendTo(std::vector<SpanVertex>& vertices) const {
    for (const MapVertexId v : map_.vertices.ids()) {
      const std::vector<MapEdgeId>& edges = map_.edges_around[v];
      const auto shows_source = [&](MapEdgeId edge) {
        return IsSource(FacetLeftOf(v, edge));
      };
      if (std::ranges::none_of(edges, shows_source)) continue;
      SpanVertex& vertex = vertices.emplace_back();
      vertex.direction = directions_[v];
      for (const MapEdgeId edge : edges)
        vertex.spans.push_back(SpanAt(v, edge));
    }
  }

 private:
  [[nodiscard]] bool IsSource(FacetId facet) const {
    return facet.valid() && facets_[facet].is_source;
  }

  /// What is seen on the left of an edge, in the chart, when leaving a vertex.
  [[nodiscard]] FacetId FacetLeftOf(MapVertexId vertex, MapEdgeId edge) const {
    const MapEdge& e = map_.edges[edge];
    return e.from == vertex ? e.left : e.right;
  }

  /// The span that begins at an edge.
  [[nodiscard]] AngularSpan SpanAt(MapVertexId vertex, MapEdgeId edge) const {
    const MapEdge& e = map_.edges[edge];
    const Vec3<Exact>& v = directions_[vertex];
    const Vec3<Exact>& w = directions_[e.from == vertex ? e.to : e.from];
    const FacetId facet = FacetLeftOf(vertex, edge);
    return {facet, IsSource(facet), w, Cross(v, w)};
  }

  const ViewMap& map_;
  FacetViews facets_;
  IdVector<MapVertexId, Vec3<Exact>> directions_;
};

}  // namespace

AngularSpans AngularSpansOf(const ContourQuery& query) {
  const IdVector<FacetId, FacetView> facets = FacetViewsOf(query);
  return AngularSpansOf(facets, ChartViewsOf(query, facets));
}

AngularSpans AngularSpansOf(FacetViews facets,
                            std::span<const ChartView> charts) {
  AngularSpans result;
  result.statistics.sources = static_cast<std::uint64_t>(
      std::ranges::count_if(facets, &FacetView::is_source));
  for (const ChartView& view : charts)
    SpanReader(view, facets).AppendTo(result.vertices);
  return result;
}

}  // namespace truelux
