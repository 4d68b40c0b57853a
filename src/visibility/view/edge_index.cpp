// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/edge_index.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <tuple>

#include "scene/scene_access.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// An edge of one triangle, the one between its corner k and the next.
struct EdgeUse {
  int a = -1;
  int b = -1;
  int triangle = -1;
  int k = 0;
  Sign side = Sign::kZero;  ///< as in EdgeNeighbour

  friend bool operator<(const EdgeUse& x, const EdgeUse& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  }
};

DirectionRecipe VertexRecipe(int v) {
  return DirectionRecipe::ToVertex(VertexId(v));
}

}  // namespace

EdgeIndex::EdgeIndex(const ContourQuery& query, std::span<const int> triangles)
    : query_(query),
      sides_(ViewOf(query)),
      exact_(ViewOf(query)),
      interval_(ViewOf(query)),
      triangles_(triangles.begin(), triangles.end()),
      edges_of_(query.scene.triangles().size()) {
  assert(std::ranges::is_sorted(triangles_));
  AddEdges();
  const RoundUpward rounding;
  for (const Edge& edge : edges_) {
    planes_.push_back(Cross(interval_.FromReceiver(VertexId(edge.a)),
                            interval_.FromReceiver(VertexId(edge.b))));
  }
}

/// Sorts the edges of all triangles, so that equal ones become neighbours.
void EdgeIndex::AddEdges() {
  std::vector<EdgeUse> uses;
  for (const int t : triangles_) {
    const auto& vertices = query_.scene.triangles()[Index(t)].vertices;
    // (from x to) . third is the triangle's height h.
    const Sign height = sides_.OfReceiver(TriangleId(t));
    assert(height != Sign::kZero);
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = vertices[k];
      const int to = vertices[(k + 1) % 3];
      const auto [a, b] = std::minmax(from, to);
      uses.push_back(
          {a, b, t, static_cast<int>(k), from == a ? height : -height});
    }
  }
  std::ranges::sort(uses, [](const auto& x, const auto& y) { return x < y; });
  for (const EdgeUse& use : uses) {
    if (edges_.empty() || edges_.back().a != use.a || edges_.back().b != use.b)
      edges_.push_back({use.a, use.b, static_cast<int>(neighbours_.size()), 0});
    ++edges_.back().neighbour_count;
    neighbours_.push_back({use.triangle, use.side});
    edges_of_[Index(use.triangle)][Index(use.k)] = {edge_count() - 1, use.side};
  }
}

int EdgeIndex::FacetOf(int triangle) const {
  return query_.scene.triangles()[Index(triangle)].facet;
}

int EdgeIndex::FaceNumber(int facet) const {
  return query_.scene.facets()[Index(facet)].face + 1;
}

const Vec3<Interval>& EdgeIndex::RoughPlane(int edge) const {
  return planes_[Index(edge)];
}

std::span<const EdgeNeighbour> EdgeIndex::NeighboursOf(int edge) const {
  const Edge& e = edges_[Index(edge)];
  return std::span(neighbours_)
      .subspan(Index(e.first_neighbour), Index(e.neighbour_count));
}

const std::array<TriangleEdge, 3>& EdgeIndex::EdgesOf(int triangle) const {
  return edges_of_[Index(triangle)];
}

/// By the first face that has the edge.
SeenEdge EdgeIndex::NameOf(int edge) const {
  const auto neighbours = NeighboursOf(edge);
  int face = FaceNumber(FacetOf(neighbours.front().triangle));
  for (const EdgeNeighbour& n : neighbours)
    face = std::min(face, FaceNumber(FacetOf(n.triangle)));
  return {face, edges_[Index(edge)].a, edges_[Index(edge)].b, 0};
}

Segment EdgeIndex::SegmentOf(int edge) const {
  const Edge& e = edges_[Index(edge)];
  return {VertexRecipe(e.a), VertexRecipe(e.b), e.a, e.b, NameOf(edge)};
}

/// Whether a triangle is of the source or can hide some of it.
bool EdgeIndex::Matters(int triangle, const FacetFront& source) const {
  return FacetOf(triangle) == source.facet() || source.CanBeHiddenBy(triangle);
}

bool EdgeIndex::GoesOn(int edge, const EdgeNeighbour& neighbour,
                       const FacetFront& source) const {
  const int own = FacetOf(neighbour.triangle);
  return std::ranges::any_of(NeighboursOf(edge), [&](const auto& other) {
    const int beyond = FacetOf(other.triangle);
    const bool is_diagonal = own == beyond;
    const bool both_hide = own != source.facet() && beyond != source.facet();
    return (is_diagonal || both_hide) &&
           neighbour.side * other.side == Sign::kNegative &&
           Matters(other.triangle, source);
  });
}

bool EdgeIndex::CouldBound(int edge, const FacetFront& source) const {
  return std::ranges::any_of(NeighboursOf(edge), [&](const auto& n) {
    return Matters(n.triangle, source) && !GoesOn(edge, n, source);
  });
}

std::optional<Segment> EdgeIndex::CutOf(int triangle,
                                        const FacetFront& source) const {
  if (FacetOf(triangle) == source.facet()) return std::nullopt;
  return source.CutOf(triangle);
}

bool EdgeIndex::IsDiagonal(int edge) const {
  const auto neighbours = NeighboursOf(edge);
  const auto face_of = [this](const EdgeNeighbour& n) {
    return FaceNumber(FacetOf(n.triangle));
  };
  return std::ranges::all_of(neighbours, [&](const EdgeNeighbour& n) {
    return std::ranges::any_of(neighbours, [&](const EdgeNeighbour& other) {
      return n.side * other.side == Sign::kNegative &&
             face_of(n) == face_of(other);
    });
  });
}

std::optional<SeenEdge> EdgeIndex::AlongArc(int facet, const Vec3<Exact>& from,
                                            const Vec3<Exact>& to) const {
  const Facet& f = query_.scene.facets()[Index(facet)];
  for (int t = f.first_triangle; t < f.first_triangle + f.triangle_count; ++t) {
    for (const TriangleEdge& own : EdgesOf(t)) {
      const auto in_facet = std::ranges::count_if(
          NeighboursOf(own.edge),
          [&](const auto& n) { return FacetOf(n.triangle) == facet; });
      if (in_facet > 1) continue;
      const Edge& edge = edges_[Index(own.edge)];
      const Vec3<Exact> a = exact_.FromReceiver(VertexId(edge.a));
      const Vec3<Exact> b = exact_.FromReceiver(VertexId(edge.b));
      if (PointOnArc(a, b, from) && PointOnArc(a, b, to))
        return NameOf(own.edge);
    }
  }
  return std::nullopt;
}

Sign EdgeIndex::DepthOrder(int facet, int other, const Vec3<Exact>& d) const {
  const auto facets = FacetsOf(query_.scene);
  const TriangleId t = FirstTriangleOf(facets[FacetId(facet)]);
  const TriangleId u = FirstTriangleOf(facets[FacetId(other)]);
  const Exact h = exact_.Height(t);
  const Exact h_other = exact_.Height(u);
  const Exact slope = Dot(exact_.TriangleNormal(t), d);
  const Exact slope_other = Dot(exact_.TriangleNormal(u), d);
  assert(SignOf(h) == SignOf(slope) && SignOf(h_other) == SignOf(slope_other));
  // h / (N . d) is the distance in units of d, positive for both.
  return SignOf(h * slope_other - h_other * slope) * SignOf(h) *
         SignOf(h_other);
}

Vec3<Exact> EdgeIndex::MeetingPlane(int facet, int other) const {
  const auto facets = FacetsOf(query_.scene);
  const TriangleId t = FirstTriangleOf(facets[FacetId(facet)]);
  const TriangleId u = FirstTriangleOf(facets[FacetId(other)]);
  return exact_.Plane(PlaneRecipe::OfCut(t, u), {});
}

}  // namespace truelux
