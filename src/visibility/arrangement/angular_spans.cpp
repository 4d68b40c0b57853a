#include "visibility/arrangement/angular_spans.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "visibility/arrangement/arrangement_view.h"

namespace truelux {
namespace {

/// Reads the span lists of one chart.
class SpanReader {
 public:
  SpanReader(const ChartView& view, std::span<const FacetView> facets)
      : map_(view.map), facets_(facets) {
    directions_.reserve(map_.vertices.size());
    for (const ImageDirection& vertex : map_.vertices) {
      directions_.push_back(view.chart.WorldFromImage(vertex));
    }
  }

  /// Adds the vertices at which a source is seen.
  void AppendTo(std::vector<SpanVertex>& vertices) const {
    for (std::size_t v = 0; v < map_.vertices.size(); ++v) {
      const std::vector<int>& edges = map_.edges_around[v];
      const auto shows_source = [&](int edge) {
        return IsSource(FacetLeftOf(static_cast<int>(v), edge));
      };
      if (std::ranges::none_of(edges, shows_source)) continue;
      SpanVertex& vertex = vertices.emplace_back();
      vertex.direction = directions_[v];
      for (const int edge : edges) {
        vertex.spans.push_back(SpanAt(static_cast<int>(v), edge));
      }
    }
  }

 private:
  const MapEdge& Edge(int i) const {
    return map_.edges[static_cast<std::size_t>(i)];
  }

  bool IsSource(int facet) const {
    return facet >= 0 && facets_[static_cast<std::size_t>(facet)].is_source;
  }

  /// What is seen on the left of an edge, in the chart, when leaving a vertex.
  int FacetLeftOf(int vertex, int edge) const {
    return Edge(edge).from == vertex ? Edge(edge).left : Edge(edge).right;
  }

  /// The span that begins at an edge.
  AngularSpan SpanAt(int vertex, int edge) const {
    const MapEdge& e = Edge(edge);
    const int end = e.from == vertex ? e.to : e.from;
    const Vec3<Exact>& v = directions_[static_cast<std::size_t>(vertex)];
    const Vec3<Exact>& w = directions_[static_cast<std::size_t>(end)];
    const int facet = FacetLeftOf(vertex, edge);
    return {facet, IsSource(facet), w, Cross(v, w)};
  }

  const ViewMap& map_;
  std::span<const FacetView> facets_;
  std::vector<Vec3<Exact>> directions_;  ///< per vertex of the map
};

}  // namespace

AngularSpans AngularSpansOf(const ContourQuery& query) {
  const std::vector<FacetView> facets = FacetViewsOf(query);
  return AngularSpansOf(facets, ChartViewsOf(query, facets));
}

AngularSpans AngularSpansOf(std::span<const FacetView> facets,
                            std::span<const ChartView> charts) {
  AngularSpans result;
  result.statistics.sources = static_cast<std::uint64_t>(
      std::ranges::count_if(facets, &FacetView::is_source));
  for (const ChartView& view : charts)
    SpanReader(view, facets).AppendTo(result.vertices);
  return result;
}

}  // namespace truelux
