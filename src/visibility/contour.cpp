// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/contour.h"

#include <optional>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// Whether triangles s and t lie in exactly the same plane.
bool Coplanar(const ReceiverView& view, TriangleId s, TriangleId t) {
  const RoundUpward rounding;
  const RecipeEvaluator<Interval> interval(view);
  const RecipeEvaluator<Exact> exact(view);
  for (const VertexId vertex : CornersOf(view.triangles[t])) {
    std::optional<Sign> sign = TrySign(interval.AboveTriangle(s, vertex));
    if (!sign) sign = SignOf(exact.AboveTriangle(s, vertex));
    if (*sign != Sign::kZero) return false;
  }
  return true;
}

}  // namespace

ReceiverView ViewOf(const ContourQuery& query) {
  return {VerticesOf(query.scene), TrianglesOf(query.scene),
          query.receiver.position, query.receiver.normal, query.displacement};
}

IgnoredFacetCache::IgnoredFacetCache(const Scene& scene) : scene_(scene) {}

void IgnoredFacetCache::SetOnFace(FaceNumber on_face) {
  if (on_face == on_face_) return;
  on_face_ = on_face;
  is_ignored_.Clear();
  is_ignored_.Cover(scene_.facets().size());
}

bool IgnoredFacetCache::Ask(FacetId facet) {
  return is_ignored_.FindOrMake(facet, [&] { return IsInPlaneOfFace(facet); });
}

/// Whether a facet lies in the plane of a facet of the face that is named.
bool IgnoredFacetCache::IsInPlaneOfFace(FacetId facet) const {
  const auto facets = FacetsOf(scene_);
  const ReceiverView view{VerticesOf(scene_), TrianglesOf(scene_), {}, {}};
  const TriangleId triangle = FirstTriangleOf(facets[facet]);
  for (const FacetId own : FacetsOf(FacesOf(scene_)[IndexOf(on_face_)])) {
    if (Coplanar(view, FirstTriangleOf(facets[own]), triangle)) return true;
  }
  return false;
}

IdVector<FacetId, bool> IgnoredFacets(const ContourQuery& query) {
  if (query.receiver.on_face == 0) return {};
  IgnoredFacetCache cache(query.scene);
  cache.SetOnFace(FaceNumber(query.receiver.on_face));
  IdVector<FacetId, bool> ignored;
  for (const FacetId facet : FacetsOf(query.scene).ids()) {
    ignored.push_back(cache.IsIgnored(facet));
  }
  return ignored;
}

}  // namespace truelux
