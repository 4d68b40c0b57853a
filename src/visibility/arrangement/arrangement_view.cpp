#include "visibility/arrangement/arrangement_view.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

/// Whether a facet counts as a source for the query.
bool CountsAsSource(const ContourQuery& query, const Facet& facet) {
  if (query.only_source != 0) return facet.face + 1 == query.only_source;
  return Emits(query.scene.faces()[static_cast<std::size_t>(facet.face)]);
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

/// All facets in a chart, clipped to its cone and cut into triangles.
std::vector<ImageTriangle> ImageOf(const ContourQuery& query,
                                   std::span<const FacetView> views,
                                   const ViewChart& chart) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  std::vector<ImageTriangle> image;
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
    }
  }
  return image;
}

}  // namespace

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
                     CountsAsSource(query, facet) &&
                     HasPointAboveHorizon(query, facet, exact);
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<ChartView> ChartViewsOf(const ContourQuery& query,
                                    std::span<const FacetView> views) {
  std::vector<ChartView> charts;
  if (std::ranges::none_of(views, &FacetView::is_source)) return charts;
  for (const ViewChart& chart : ViewChartsOf(query.receiver.normal)) {
    const std::vector<ImageTriangle> image = ImageOf(query, views, chart);
    const bool has_source =
        std::ranges::any_of(image, [&](const ImageTriangle& t) {
          return views[static_cast<std::size_t>(t.facet)].is_source;
        });
    if (has_source) charts.push_back({chart, FrontMost(image)});
  }
  return charts;
}

ChartView WholeChartViewOf(const ContourQuery& query,
                           std::span<const FacetView> views,
                           std::size_t chart) {
  const ViewChart own = ViewChartsOf(query.receiver.normal)[chart];
  return {own, FrontMost(ImageOf(query, views, own), MapWalls::kClosed)};
}

}  // namespace truelux
