#include "visibility/contour.h"

#include <optional>

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

std::vector<bool> IgnoredFacets(const ContourQuery& query) {
  if (query.receiver.on_face == 0) return {};
  const auto facets = query.scene.facets();
  const Face& face =
      query.scene.faces()[static_cast<std::size_t>(query.receiver.on_face - 1)];
  const ReceiverView view = ViewOf(query);
  std::vector<bool> ignored(facets.size(), false);
  for (int own = face.first_facet; own < face.first_facet + face.facet_count;
       ++own) {
    const int plane = facets[static_cast<std::size_t>(own)].first_triangle;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      if (ignored[f]) continue;
      ignored[f] = Coplanar(view, plane, facets[f].first_triangle);
    }
  }
  return ignored;
}

}  // namespace truelux
