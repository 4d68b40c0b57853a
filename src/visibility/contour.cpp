#include "visibility/contour.h"

#include <optional>

#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

/// Whether triangles s and t lie in exactly the same plane.
bool Coplanar(const ReceiverView& view, int s, int t) {
  const RoundUpward rounding;
  const RecipeEvaluator<Interval> interval(view);
  const RecipeEvaluator<Exact> exact(view);
  for (const int vertex :
       view.triangles[static_cast<std::size_t>(t)].vertices) {
    std::optional<Sign> sign = TrySign(interval.AboveTriangle(s, vertex));
    if (!sign) sign = SignOf(exact.AboveTriangle(s, vertex));
    if (*sign != Sign::kZero) return false;
  }
  return true;
}

}  // namespace

ReceiverView ViewOf(const ContourQuery& query) {
  return {query.scene.vertices(), query.scene.triangles(),
          query.receiver.position, query.receiver.normal};
}

IgnoredFacetCache::IgnoredFacetCache(const Scene& scene) : scene_(scene) {}

void IgnoredFacetCache::SetOnFace(int on_face) {
  if (on_face == on_face_) return;
  on_face_ = on_face;
  is_ignored_.Clear();
  is_ignored_.Cover(scene_.facets().size());
}

bool IgnoredFacetCache::Ask(int facet) {
  return is_ignored_.FindOrMake(facet, [&] { return IsInPlaneOfFace(facet); });
}

/// Whether a facet lies in the plane of a facet of the face that is named.
bool IgnoredFacetCache::IsInPlaneOfFace(int facet) const {
  const auto facets = scene_.facets();
  const Face& face = scene_.faces()[static_cast<std::size_t>(on_face_ - 1)];
  const ReceiverView view{scene_.vertices(), scene_.triangles(), {}, {}};
  const int triangle = facets[static_cast<std::size_t>(facet)].first_triangle;
  for (int own = face.first_facet; own < face.first_facet + face.facet_count;
       ++own) {
    const int plane = facets[static_cast<std::size_t>(own)].first_triangle;
    if (Coplanar(view, plane, triangle)) return true;
  }
  return false;
}

std::vector<bool> IgnoredFacets(const ContourQuery& query) {
  if (query.receiver.on_face == 0) return {};
  IgnoredFacetCache cache(query.scene);
  cache.SetOnFace(query.receiver.on_face);
  std::vector<bool> ignored;
  for (std::size_t f = 0; f < query.scene.facets().size(); ++f) {
    ignored.push_back(cache.IsIgnored(static_cast<int>(f)));
  }
  return ignored;
}

}  // namespace truelux
