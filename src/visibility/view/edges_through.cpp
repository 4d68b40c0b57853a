#include "visibility/view/edges_through.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

Vec3<Interval> RoughOf(const Vec3<Exact>& v) {
  return {FromExact<Interval>::Of(v.x), FromExact<Interval>::Of(v.y),
          FromExact<Interval>::Of(v.z)};
}

bool IsZero(const Vec3<Exact>& v) {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

}  // namespace

EdgesThrough::EdgesThrough(const ContourQuery& query,
                           IdSpan<FacetId, const FacetView> views)
    : query_(query), views_(views), exact_(ViewOf(query)) {
  const auto triangles = query.scene.triangles();
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    AddTriangle(t);
  rough_side_.resize(edges_.size());
}

void EdgesThrough::AddTriangle(int triangle) {
  edges_of_.push_back({-1, -1, -1});
  const FacetView& view = views_[Index(FacetOf(triangle))];
  if (!view.blocks) return;
  const Triangle& t = query_.scene.triangles()[Index(triangle)];
  for (std::size_t k = 0; k < 3; ++k) {
    const int from = t.vertices[k];
    const int to = t.vertices[(k + 1) % 3];
    const auto [a, b] = std::minmax(from, to);
    const auto [entry, is_new] =
        edge_index_.try_emplace({a, b}, static_cast<int>(edges_.size()));
    if (is_new) {
      Edge edge;
      edge.a = a;
      edge.b = b;
      edge.plane = Cross(exact_.FromReceiver(VertexId(a)),
                         exact_.FromReceiver(VertexId(b)));
      const RoundUpward rounding;
      edge.rough_plane = RoughOf(edge.plane);
      edges_.push_back(std::move(edge));
    }
    // (from x to) . third is the triangle's height.
    const Sign side = SignOf(view.height);
    edges_[Index(entry->second)].neighbours.push_back(
        {triangle, from == a ? side : -side});
    edges_of_.back()[k] = entry->second;
  }
}

void EdgesThrough::Look(const Vec3<Exact>& d) {
  d_ = d;
  {
    const RoundUpward rounding;
    const Vec3<Interval> rough = RoughOf(d);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto sign = TrySign(Dot(edges_[e].rough_plane, rough));
      rough_side_[e] = sign ? static_cast<std::int8_t>(*sign) : std::int8_t{0};
    }
  }
  FindEdges();
  FindTriangles();
}

void EdgesThrough::FindEdges() {
  passing_.clear();
  for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
    if (rough_side_[Index(e)] != 0) continue;
    const Edge& edge = edges_[Index(e)];
    const Sign side = SignOf(Dot(edge.plane, d_));
    if (side != Sign::kZero) {
      rough_side_[Index(e)] = static_cast<std::int8_t>(side);
      continue;
    }
    const Vec3<Exact> a = exact_.FromReceiver(VertexId(edge.a));
    const Vec3<Exact> b = exact_.FromReceiver(VertexId(edge.b));
    Passing passing{e, -1, Dot(Cross(d_, b), edge.plane),
                    Dot(Cross(a, d_), edge.plane)};
    const Sign at_a = SignOf(passing.weight_a);
    const Sign at_b = SignOf(passing.weight_b);
    if (at_a == Sign::kNegative || at_b == Sign::kNegative) continue;
    if (at_b == Sign::kZero) passing.vertex = edge.a;
    if (at_a == Sign::kZero) passing.vertex = edge.b;
    passing_.push_back(std::move(passing));
  }
}

void EdgesThrough::FindTriangles() {
  triangles_.clear();
  const auto triangles = query_.scene.triangles();
  for (int t = 0; t < static_cast<int>(edges_of_.size()); ++t) {
    const std::array<int, 3>& own = edges_of_[Index(t)];
    if (own[0] < 0) continue;
    const Sign height = SignOf(views_[Index(FacetOf(t))].height);
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
      const int from = triangles[Index(t)].vertices[k];
      const Sign side = SideOf(own[k]);
      const Sign turn = edges_[Index(own[k])].a == from ? side : -side;
      inside = turn * height != Sign::kNegative;
    }
    if (inside) triangles_.push_back(t);
  }
}

/// The side of an edge's plane on which the direction is.
Sign EdgesThrough::SideOf(int edge) const {
  return static_cast<Sign>(rough_side_[Index(edge)]);
}

int EdgesThrough::FacetOf(int triangle) const {
  return query_.scene.triangles()[Index(triangle)].facet;
}

int EdgesThrough::FaceOf(int facet) const {
  return query_.scene.facets()[Index(facet)].face;
}

/// Positive if a vertex is on r's side of a facet's plane.
Sign EdgesThrough::InFrontOfPlane(int facet, int vertex) const {
  const int triangle = query_.scene.facets()[Index(facet)].first_triangle;
  return SignOf(exact_.AboveTriangle(TriangleId(triangle), VertexId(vertex))) *
         -SignOf(views_[Index(facet)].height);
}

bool EdgesThrough::BlocksSource(int triangle, int facet) const {
  const int own = FacetOf(triangle);
  if (own == facet) return true;
  bool all_on = true;
  for (const int v : query_.scene.triangles()[Index(triangle)].vertices) {
    const Sign side = InFrontOfPlane(facet, v);
    if (side == Sign::kPositive) return true;
    all_on = all_on && side == Sign::kZero;
  }
  return all_on && FaceOf(own) < FaceOf(facet);
}

/// Whether a triangle goes on beyond an edge as one of the same facet, or as
/// another blocker.
bool EdgesThrough::IsInner(const Edge& edge, const Neighbour& neighbour,
                           int facet) const {
  const int own = FacetOf(neighbour.triangle);
  return std::ranges::any_of(edge.neighbours, [&](const Neighbour& other) {
    const int beyond = FacetOf(other.triangle);
    const bool diagonal = own == beyond;
    const bool both_block = own != facet && beyond != facet;
    return (diagonal || both_block) &&
           neighbour.side * other.side == Sign::kNegative &&
           BlocksSource(other.triangle, facet);
  });
}

bool EdgesThrough::BoundsSource(const Edge& edge, int facet) const {
  return std::ranges::any_of(edge.neighbours, [&](const Neighbour& n) {
    return BlocksSource(n.triangle, facet) && !IsInner(edge, n, facet);
  });
}

/// Whether all faces at an edge go on beyond it.
bool EdgesThrough::IsDiagonal(const Edge& edge) const {
  return std::ranges::all_of(edge.neighbours, [&](const Neighbour& n) {
    return std::ranges::any_of(edge.neighbours, [&](const Neighbour& other) {
      return n.side * other.side == Sign::kNegative &&
             FaceOf(FacetOf(n.triangle)) == FaceOf(FacetOf(other.triangle));
    });
  });
}

bool EdgesThrough::IsBehind(const Passing& passing, int facet) const {
  const Edge& edge = edges_[Index(passing.edge)];
  const int triangle = query_.scene.facets()[Index(facet)].first_triangle;
  const Exact above =
      passing.weight_a *
          exact_.AboveTriangle(TriangleId(triangle), VertexId(edge.a)) +
      passing.weight_b *
          exact_.AboveTriangle(TriangleId(triangle), VertexId(edge.b));
  return SignOf(above) * -SignOf(views_[Index(facet)].height) ==
         Sign::kNegative;
}

SeenEdge EdgesThrough::Name(const Edge& edge) const {
  int face = FaceOf(FacetOf(edge.neighbours.front().triangle));
  for (const Neighbour& n : edge.neighbours)
    face = std::min(face, FaceOf(FacetOf(n.triangle)));
  return {face + 1, edge.a, edge.b, 0};
}

EdgeHit EdgesThrough::HitOf(const Passing& passing) const {
  const Edge& edge = edges_[Index(passing.edge)];
  return {edge.plane, passing.vertex, Name(edge)};
}

std::vector<EdgeHit> EdgesThrough::OfSource(int facet) const {
  std::vector<EdgeHit> hits;
  for (const Passing& passing : passing_) {
    if (!BoundsSource(edges_[Index(passing.edge)], facet)) continue;
    if (!IsBehind(passing, facet)) hits.push_back(HitOf(passing));
  }
  for (const int t : triangles_) {
    if (auto cut = CutAt(t, facet)) hits.push_back(*std::move(cut));
  }
  return hits;
}

/// Whether a scene vertex lies in the direction.
bool EdgesThrough::IsVertex(int vertex) const {
  const Vec3<Exact> v = exact_.FromReceiver(VertexId(vertex));
  return IsZero(Cross(v, d_)) && SignOf(Dot(v, d_)) == Sign::kPositive;
}

/// The plane through r and the line where the planes of two facets meet.
Vec3<Exact> EdgesThrough::CutNormal(int facet_a, int facet_b) const {
  const FacetView& a = views_[Index(facet_a)];
  const FacetView& b = views_[Index(facet_b)];
  return b.height * a.normal - a.height * b.normal;
}

/// The line where a triangle crosses a facet's plane, if it passes through the
/// direction.
std::optional<EdgeHit> EdgesThrough::CutAt(int triangle, int facet) const {
  const int own = FacetOf(triangle);
  if (own == facet) return std::nullopt;
  int vertex = -1;
  bool any_front = false;
  bool any_back = false;
  for (const int v : query_.scene.triangles()[Index(triangle)].vertices) {
    const Sign side = InFrontOfPlane(facet, v);
    any_front = any_front || side == Sign::kPositive;
    any_back = any_back || side == Sign::kNegative;
    if (side == Sign::kZero && IsVertex(v)) vertex = v;
  }
  if (!any_front || !any_back) return std::nullopt;
  if (DepthOrder(own, facet, d_) != Sign::kZero) return std::nullopt;
  return EdgeHit{CutNormal(own, facet), vertex,
                 SeenEdge{FaceOf(own) + 1, -1, -1, FaceOf(facet) + 1}};
}

Sign EdgesThrough::DepthOrder(int facet_a, int facet_b,
                              const Vec3<Exact>& d) const {
  const FacetView& a = views_[Index(facet_a)];
  const FacetView& b = views_[Index(facet_b)];
  // height / (normal . d) is the distance in units of d, positive for both.
  return SignOf(a.height * Dot(b.normal, d) - b.height * Dot(a.normal, d)) *
         SignOf(a.height) * SignOf(b.height);
}

std::vector<EdgeHit> EdgesThrough::NotBehind(int facet) const {
  std::vector<EdgeHit> hits;
  for (const Passing& passing : passing_) {
    if (IsDiagonal(edges_[Index(passing.edge)])) continue;
    if (facet < 0 || !IsBehind(passing, facet)) hits.push_back(HitOf(passing));
  }
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const int s = triangles_[i];
    if (facet >= 0 && FacetOf(s) != facet &&
        DepthOrder(FacetOf(s), facet, d_) == Sign::kPositive) {
      continue;
    }
    for (std::size_t j = i + 1; j < triangles_.size(); ++j) {
      auto meeting = MeetingAt(s, triangles_[j]);
      if (!meeting) continue;
      const bool is_edge = std::ranges::any_of(passing_, [&](const Passing& p) {
        return IsZero(Cross(edges_[Index(p.edge)].plane, meeting->plane));
      });
      if (!is_edge) hits.push_back(*std::move(meeting));
    }
  }
  return hits;
}

/// The segment in which two triangles cross, if the direction is on it.
std::optional<EdgeHit> EdgesThrough::MeetingAt(int s, int t) const {
  const int own = FacetOf(s);
  const int other = FacetOf(t);
  if (FaceOf(own) == FaceOf(other)) return std::nullopt;
  const auto& v = query_.scene.triangles()[Index(s)].vertices;
  const auto& w = query_.scene.triangles()[Index(t)].vertices;
  const auto shared = std::ranges::count_if(
      v, [&w](int i) { return std::ranges::find(w, i) != w.end(); });
  if (shared > 1) return std::nullopt;
  if (DepthOrder(own, other, d_) != Sign::kZero) return std::nullopt;
  const Vec3<Exact> plane = CutNormal(own, other);
  if (IsZero(plane)) return std::nullopt;
  // The ends of both segments around the direction; of those on one side of it
  // the nearer ones must not be at the direction itself.
  int vertex = -1;
  bool goes_back = true;
  bool goes_on = true;
  for (const auto* corners : {&v, &w}) {
    std::array<Exact, 3> value;
    for (std::size_t k = 0; k < 3; ++k)
      value[k] = Dot(plane, exact_.FromReceiver(VertexId((*corners)[k])));
    bool back = false;
    bool on = false;
    const auto add_end = [&](const Vec3<Exact>& end) {
      const Sign side = SignOf(Dot(Cross(d_, end), plane));
      back = back || side == Sign::kNegative;
      on = on || side == Sign::kPositive;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3<Exact> p = exact_.FromReceiver(VertexId((*corners)[k]));
      const Vec3<Exact> q = exact_.FromReceiver(VertexId((*corners)[next]));
      if (value[k].is_zero()) {
        add_end(p);
        if (IsVertex((*corners)[k])) vertex = (*corners)[k];
      } else if (SignOf(value[k]) * SignOf(value[next]) == Sign::kNegative) {
        const Vec3<Exact> end = value[k] * q - value[next] * p;
        add_end(SignOf(value[k]) == Sign::kPositive ? end : -end);
      }
    }
    goes_back = goes_back && back;
    goes_on = goes_on && on;
  }
  if (!goes_back && !goes_on) return std::nullopt;
  if (goes_back && goes_on) vertex = -1;
  return EdgeHit{plane, vertex,
                 SeenEdge{std::min(FaceOf(own), FaceOf(other)) + 1, -1, -1,
                          std::max(FaceOf(own), FaceOf(other)) + 1}};
}

std::optional<SeenEdge> EdgesThrough::AlongArc(int facet,
                                               const Vec3<Exact>& from,
                                               const Vec3<Exact>& to) const {
  const Facet& f = query_.scene.facets()[Index(facet)];
  for (int t = f.first_triangle; t < f.first_triangle + f.triangle_count; ++t) {
    for (const int e : edges_of_[Index(t)]) {
      const Edge& edge = edges_[Index(e)];
      const auto in_facet = std::ranges::count_if(
          edge.neighbours,
          [&](const Neighbour& n) { return FacetOf(n.triangle) == facet; });
      if (in_facet > 1) continue;
      const Vec3<Exact> a = exact_.FromReceiver(VertexId(edge.a));
      const Vec3<Exact> b = exact_.FromReceiver(VertexId(edge.b));
      const bool holds =
          std::ranges::all_of(std::array{&from, &to}, [&](const auto* d) {
            return Dot(edge.plane, *d).is_zero() &&
                   SignOf(Dot(Cross(a, *d), edge.plane)) != Sign::kNegative &&
                   SignOf(Dot(Cross(*d, b), edge.plane)) != Sign::kNegative;
          });
      if (holds) return Name(edge);
    }
  }
  return std::nullopt;
}

bool EdgesThrough::Share(int facet_a, int facet_b, const SeenEdge& edge) const {
  const auto entry = edge_index_.find({edge.a, edge.b});
  if (entry == edge_index_.end()) return false;
  const auto has = [&](int facet) {
    return std::ranges::any_of(
        edges_[Index(entry->second)].neighbours,
        [&](const Neighbour& n) { return FacetOf(n.triangle) == facet; });
  };
  return has(facet_a) && has(facet_b);
}

}  // namespace truelux
