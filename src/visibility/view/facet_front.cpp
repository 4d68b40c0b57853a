// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/facet_front.h"

#include <array>
#include <cassert>
#include <cstddef>

#include "scene/coplanar_order.h"
#include "scene/scene_access.h"

namespace truelux {

FacetFront::FacetFront(const ContourQuery& query, FacetId facet)
    : query_(query),
      sides_(ViewOf(query)),
      facet_(facet),
      triangle_(FirstTriangleOf(FacetsOf(query.scene)[facet])),
      receiver_side_(-sides_.OfReceiver(triangle_)) {
  assert(receiver_side_ != Sign::kZero);
}

Sign FacetFront::SideOf(VertexId vertex) const {
  return sides_.OfVertex(triangle_, vertex) * receiver_side_;
}

bool FacetFront::IsBehind(const Segment& segment, const ArcPoint& point) const {
  if (segment.IsCut()) return false;
  // The height above a plane is linear between the ends, and so is the image:
  // the weights are those of the point on the segment.
  const RecipeEvaluator<Exact>& exact = sides_.exact();
  const Exact above =
      point.weight_from * exact.AboveTriangle(triangle_, segment.a) +
      point.weight_to * exact.AboveTriangle(triangle_, segment.b);
  return SignOf(above) * receiver_side_ == Sign::kNegative;
}

bool FacetFront::CanBeHiddenBy(TriangleId triangle) const {
  const Triangle& t = TrianglesOf(query_.scene)[triangle];
  const FacetId facet = FacetOf(t);
  assert(facet != facet_);
  bool all_on = true;
  for (const VertexId v : CornersOf(t)) {
    const Sign side = SideOf(v);
    if (side == Sign::kPositive) return true;
    all_on = all_on && side == Sign::kZero;
  }
  if (!all_on) return false;
  const bool shows_front = sides_.OfReceiver(triangle) == Sign::kNegative;
  return IsSeenBefore(query_.scene, {facet, shows_front},
                      {facet_, receiver_side_ == Sign::kPositive});
}

std::optional<Segment> FacetFront::CutOf(TriangleId triangle) const {
  const Triangle& t = TrianglesOf(query_.scene)[triangle];
  const FacetId facet = FacetOf(t);
  assert(facet != facet_);
  const std::array<VertexId, 3> corners = CornersOf(t);
  std::array<Sign, 3> side{};
  bool any_in_front = false;
  bool any_behind = false;
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = SideOf(corners[k]);
    any_in_front = any_in_front || side[k] == Sign::kPositive;
    any_behind = any_behind || side[k] == Sign::kNegative;
  }
  if (!any_in_front || !any_behind) return std::nullopt;
  Segment cut;
  bool is_first = true;
  const auto add_end = [&](const DirectionRecipe& end, VertexId vertex) {
    (is_first ? cut.from : cut.to) = end;
    (is_first ? cut.a : cut.b) = vertex;
    is_first = false;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const VertexId a = corners[k];
    const VertexId b = corners[next];
    if (side[k] == Sign::kZero) add_end(DirectionRecipe::ToVertex(a), a);
    if (side[k] * side[next] != Sign::kNegative) continue;
    // The recipe begins with the vertex in front of the triangle.
    const bool a_first = side[k] == receiver_side_;
    add_end(DirectionRecipe::EdgeAtPlane(a_first ? a : b, a_first ? b : a,
                                         triangle_),
            VertexId());
  }
  cut.edge = {NumberOf(FaceOf(query_.scene, facet)).value(), -1, -1,
              NumberOf(FaceOf(query_.scene, facet_)).value()};
  return cut;
}

}  // namespace truelux
