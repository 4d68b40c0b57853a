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
  VertexId a;
  VertexId b;
  TriangleId triangle;
  std::size_t k = 0;
  Sign side = Sign::kZero;  ///< as in EdgeNeighbour

  friend bool operator<(const EdgeUse& x, const EdgeUse& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  }
};

}  // namespace

EdgeIndex::EdgeIndex(const ContourQuery& query,
                     std::span<const TriangleId> triangles)
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
    planes_.push_back(
        Cross(interval_.FromReceiver(edge.a), interval_.FromReceiver(edge.b)));
  }
}

/// Sorts the edges of all triangles, so that equal ones become neighbours.
void EdgeIndex::AddEdges() {
  std::vector<EdgeUse> uses;
  for (const TriangleId t : triangles_) {
    const auto vertices = CornersOf(TrianglesOf(query_.scene)[t]);
    // (from x to) . third is the triangle's height h.
    const Sign height = sides_.OfReceiver(t);
    assert(height != Sign::kZero);
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId from = vertices[k];
      const VertexId to = vertices[(k + 1) % 3];
      const auto [a, b] = std::minmax(from, to);
      uses.push_back({a, b, t, k, from == a ? height : -height});
    }
  }
  std::ranges::sort(uses, [](const auto& x, const auto& y) { return x < y; });
  for (const EdgeUse& use : uses) {
    if (edges_.empty() || edges_.back().a != use.a || edges_.back().b != use.b)
      edges_.push_back({use.a, use.b, static_cast<int>(neighbours_.size()), 0});
    ++edges_.back().neighbour_count;
    neighbours_.push_back({use.triangle, use.side});
    edges_of_[use.triangle][use.k] = {SceneEdgeId(edges_.end_id().value() - 1),
                                      use.side};
  }
}

FacetId EdgeIndex::FacetOf(TriangleId triangle) const {
  return truelux::FacetOf(TrianglesOf(query_.scene)[triangle]);
}

int EdgeIndex::FaceNumber(FacetId facet) const {
  return NumberOf(FaceOf(query_.scene, facet)).value();
}

const Vec3<Interval>& EdgeIndex::RoughPlane(SceneEdgeId edge) const {
  return planes_[edge];
}

std::span<const EdgeNeighbour> EdgeIndex::NeighboursOf(SceneEdgeId edge) const {
  const Edge& e = edges_[edge];
  return std::span(neighbours_)
      .subspan(Index(e.first_neighbour), Index(e.neighbour_count));
}

const std::array<TriangleEdge, 3>& EdgeIndex::EdgesOf(
    TriangleId triangle) const {
  return edges_of_[triangle];
}

/// By the first face that has the edge.
SeenEdge EdgeIndex::NameOf(SceneEdgeId edge) const {
  const auto neighbours = NeighboursOf(edge);
  int face = FaceNumber(FacetOf(neighbours.front().triangle));
  for (const EdgeNeighbour& n : neighbours)
    face = std::min(face, FaceNumber(FacetOf(n.triangle)));
  return {face, edges_[edge].a.value(), edges_[edge].b.value(), 0};
}

Segment EdgeIndex::SegmentOf(SceneEdgeId edge) const {
  const Edge& e = edges_[edge];
  return {DirectionRecipe::ToVertex(e.a), DirectionRecipe::ToVertex(e.b), e.a,
          e.b, NameOf(edge)};
}

/// Whether a triangle is of the source or can hide some of it.
bool EdgeIndex::Matters(TriangleId triangle, const FacetFront& source) const {
  return FacetOf(triangle) == source.facet() || source.CanBeHiddenBy(triangle);
}

bool EdgeIndex::GoesOn(SceneEdgeId edge, const EdgeNeighbour& neighbour,
                       const FacetFront& source) const {
  const FacetId own = FacetOf(neighbour.triangle);
  return std::ranges::any_of(NeighboursOf(edge), [&](const auto& other) {
    const FacetId beyond = FacetOf(other.triangle);
    const bool is_diagonal = own == beyond;
    const bool both_hide = own != source.facet() && beyond != source.facet();
    return (is_diagonal || both_hide) &&
           neighbour.side * other.side == Sign::kNegative &&
           Matters(other.triangle, source);
  });
}

bool EdgeIndex::CouldBound(SceneEdgeId edge, const FacetFront& source) const {
  return std::ranges::any_of(NeighboursOf(edge), [&](const auto& n) {
    return Matters(n.triangle, source) && !GoesOn(edge, n, source);
  });
}

std::optional<Segment> EdgeIndex::CutOf(TriangleId triangle,
                                        const FacetFront& source) const {
  if (FacetOf(triangle) == source.facet()) return std::nullopt;
  return source.CutOf(triangle);
}

bool EdgeIndex::IsDiagonal(SceneEdgeId edge) const {
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

std::optional<SeenEdge> EdgeIndex::AlongArc(FacetId facet,
                                            const Vec3<Exact>& from,
                                            const Vec3<Exact>& to) const {
  const Facet& f = FacetsOf(query_.scene)[facet];
  for (const TriangleId t :
       IdRange<TriangleId>(FirstTriangleOf(f), f.triangle_count)) {
    for (const TriangleEdge& own : EdgesOf(t)) {
      const auto in_facet = std::ranges::count_if(
          NeighboursOf(own.edge),
          [&](const auto& n) { return FacetOf(n.triangle) == facet; });
      if (in_facet > 1) continue;
      const Edge& edge = edges_[own.edge];
      const Vec3<Exact> a = exact_.FromReceiver(edge.a);
      const Vec3<Exact> b = exact_.FromReceiver(edge.b);
      if (PointOnArc(a, b, from) && PointOnArc(a, b, to))
        return NameOf(own.edge);
    }
  }
  return std::nullopt;
}

Sign EdgeIndex::DepthOrder(FacetId facet, FacetId other,
                           const Vec3<Exact>& d) const {
  const auto facets = FacetsOf(query_.scene);
  const TriangleId t = FirstTriangleOf(facets[facet]);
  const TriangleId u = FirstTriangleOf(facets[other]);
  const Exact h = exact_.Height(t);
  const Exact h_other = exact_.Height(u);
  const Exact slope = Dot(exact_.TriangleNormal(t), d);
  const Exact slope_other = Dot(exact_.TriangleNormal(u), d);
  assert(SignOf(h) == SignOf(slope) && SignOf(h_other) == SignOf(slope_other));
  // h / (N . d) is the distance in units of d, positive for both.
  return SignOf(h * slope_other - h_other * slope) * SignOf(h) *
         SignOf(h_other);
}

Vec3<Exact> EdgeIndex::MeetingPlane(FacetId facet, FacetId other) const {
  const auto facets = FacetsOf(query_.scene);
  const TriangleId t = FirstTriangleOf(facets[facet]);
  const TriangleId u = FirstTriangleOf(facets[other]);
  return exact_.Plane(PlaneRecipe::OfCut(t, u), {});
}

}  // namespace truelux
