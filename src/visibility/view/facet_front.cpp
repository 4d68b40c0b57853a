// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/facet_front.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

FacetFront::FacetFront(const ContourQuery& query, int facet)
    : query_(query),
      sides_(ViewOf(query)),
      facet_(facet),
      triangle_(query.scene.facets()[Index(facet)].first_triangle),
      receiver_side_(-sides_.OfReceiver(TriangleId(triangle_))) {
  assert(receiver_side_ != Sign::kZero);
}

const Triangle& FacetFront::At(int triangle) const {
  return query_.scene.triangles()[Index(triangle)];
}

int FacetFront::FaceOf(int facet) const {
  return query_.scene.facets()[Index(facet)].face;
}

Sign FacetFront::SideOf(int vertex) const {
  return sides_.OfVertex(TriangleId(triangle_), VertexId(vertex)) *
         receiver_side_;
}

bool FacetFront::IsBehind(const Segment& segment, const ArcPoint& point) const {
  if (segment.IsCut()) return false;
  // The height above a plane is linear between the ends, and so is the image:
  // the weights are those of the point on the segment.
  const RecipeEvaluator<Exact>& exact = sides_.exact();
  const Exact above =
      point.weight_from *
          exact.AboveTriangle(TriangleId(triangle_), VertexId(segment.a)) +
      point.weight_to *
          exact.AboveTriangle(TriangleId(triangle_), VertexId(segment.b));
  return SignOf(above) * receiver_side_ == Sign::kNegative;
}

bool FacetFront::CanBeHiddenBy(int triangle) const {
  const Triangle& t = At(triangle);
  assert(t.facet != facet_);
  bool all_on = true;
  for (const int v : t.vertices) {
    const Sign side = SideOf(v);
    if (side == Sign::kPositive) return true;
    all_on = all_on && side == Sign::kZero;
  }
  return all_on && FaceOf(t.facet) < FaceOf(facet_);
}

std::optional<Segment> FacetFront::CutOf(int triangle) const {
  const Triangle& t = At(triangle);
  assert(t.facet != facet_);
  std::array<Sign, 3> side{};
  bool any_in_front = false;
  bool any_behind = false;
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = SideOf(t.vertices[k]);
    any_in_front = any_in_front || side[k] == Sign::kPositive;
    any_behind = any_behind || side[k] == Sign::kNegative;
  }
  if (!any_in_front || !any_behind) return std::nullopt;
  Segment cut;
  bool is_first = true;
  const auto add_end = [&](const DirectionRecipe& end, int vertex) {
    (is_first ? cut.from : cut.to) = end;
    (is_first ? cut.a : cut.b) = vertex;
    is_first = false;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const int a = t.vertices[k];
    const int b = t.vertices[next];
    if (side[k] == Sign::kZero)
      add_end(DirectionRecipe::ToVertex(VertexId(a)), a);
    if (side[k] * side[next] != Sign::kNegative) continue;
    // The recipe begins with the vertex in front of the triangle.
    const bool a_first = side[k] == receiver_side_;
    add_end(DirectionRecipe::EdgeAtPlane(VertexId(a_first ? a : b),
                                         VertexId(a_first ? b : a),
                                         TriangleId(triangle_)),
            -1);
  }
  cut.edge = {FaceOf(t.facet) + 1, -1, -1, FaceOf(facet_) + 1};
  return cut;
}

}  // namespace truelux
