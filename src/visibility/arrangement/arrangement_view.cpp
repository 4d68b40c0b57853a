// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_view.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/stop.h"
#include "exact/recipe_evaluator.h"
#include "scene/emitters.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// Whether a facet counts as a source for the query.
bool CountsAsSource(const ContourQuery& query, const Facet& facet) {
  const FaceId face = FaceOf(facet);
  if (query.only_source.valid()) return NumberOf(face) == query.only_source;
  return Emits(FacesOf(query.scene)[face]);
}

bool HasPointAboveHorizon(const ContourQuery& query, const Facet& facet,
                          const RecipeEvaluator<Exact>& exact) {
  for (const Triangle& triangle : TrianglesOf(query.scene, facet)) {
    for (const VertexId v : CornersOf(triangle)) {
      if (SignOf(exact.AboveHorizon(v)) == Sign::kPositive) return true;
    }
  }
  return false;
}

/// All facets in a chart, clipped to its cone and cut into triangles.
std::vector<ImageTriangle> ImageOf(const ContourQuery& query, FacetViews views,
                                   const ViewChart& chart) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  std::vector<ImageTriangle> image;
  for (const Triangle& triangle : query.scene.triangles()) {
    const FacetView& view = views[FacetOf(triangle)];
    if (!view.blocks) continue;
    const int coplanar_class =
        CoplanarClass(query.scene, view.Seen(FacetOf(triangle)));
    const auto [a, b, c] = CornersOf(triangle);
    std::vector<ImagePoint> polygon;
    for (const WorldPoint& p :
         chart.Clip({exact.FromReceiver(a), exact.FromReceiver(b),
                     exact.FromReceiver(c)})) {
      polygon.push_back(chart.ImageFromWorld(p));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      image.push_back({{polygon[0], polygon[k - 1], polygon[k]},
                       FacetOf(triangle),
                       coplanar_class});
    }
  }
  return image;
}

}  // namespace

IdVector<FacetId, FacetView> FacetViewsOf(const ContourQuery& query) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  const IdVector<FacetId, bool> ignored = IgnoredFacets(query);
  IdVector<FacetId, FacetView> views;
  for (const FacetId id : FacetsOf(query.scene).ids()) {
    const Facet& facet = FacetsOf(query.scene)[id];
    FacetView view;
    view.normal = exact.TriangleNormal(FirstTriangleOf(facet));
    view.height = exact.Height(FirstTriangleOf(facet));
    const Sign side = SignOf(view.height);
    view.blocks = side != Sign::kZero && (ignored.empty() || !ignored[id]);
    view.is_source = view.blocks && side == Sign::kNegative &&
                     CountsAsSource(query, facet) &&
                     HasPointAboveHorizon(query, facet, exact);
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<ChartView> ChartViewsOf(const ContourQuery& query,
                                    FacetViews views) {
  std::vector<ChartView> charts;
  if (std::ranges::none_of(views, &FacetView::is_source)) return charts;
  for (const ViewChart& chart : ViewChartsOf(query.receiver.normal)) {
    StopIfAsked(query.stop);
    const std::vector<ImageTriangle> image = ImageOf(query, views, chart);
    const bool has_source = std::ranges::any_of(
        image,
        [&](const ImageTriangle& t) { return views[t.facet].is_source; });
    if (has_source) charts.push_back({chart, FrontMost(image)});
  }
  return charts;
}

ChartView WholeChartViewOf(const ContourQuery& query, FacetViews views,
                           std::size_t chart) {
  const ViewChart own = ViewChartsOf(query.receiver.normal)[chart];
  return {own, FrontMost(ImageOf(query, views, own), MapWalls::kClosed)};
}

}  // namespace truelux
