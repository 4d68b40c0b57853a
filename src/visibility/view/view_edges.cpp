#include "visibility/view/view_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

DirectionRecipe VertexRecipe(int v) {
  return DirectionRecipe::ToVertex(VertexId(v));
}

double Length(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

/// Of length 1; the largest component is taken out first, so that nothing
/// leaves binary64. (0, 0, 0) stays.
Vec3<double> UnitOf(const Vec3<double>& d) {
  const double largest =
      std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (!(largest > 0)) return d;
  const Vec3<double> scaled{d.x / largest, d.y / largest, d.z / largest};
  return 1 / Length(scaled) * scaled;
}

template <class NT>
Vec3<double> UnitOf(const Vec3<NT>& v) {
  return UnitOf(Vec3<double>{CGAL::to_double(v.x), CGAL::to_double(v.y),
                             CGAL::to_double(v.z)});
}

double AngleBetween(const Vec3<double>& a, const Vec3<double>& b) {
  return std::atan2(Length(Cross(a, b)), Dot(a, b));
}

/// No more than the angle from d to the arc of some length that begins at
/// `from`: an angle is no less than its chord.
double LeastAngle(const Vec3<double>& d, const Vec3<double>& from,
                  double length) {
  return Length(d - from) - length;
}

/// The angle from d to the arc between two directions less than pi apart, all
/// of length 1; normal: of the arc's plane.
double AngleToArc(const Vec3<double>& d, const Vec3<double>& from,
                  const Vec3<double>& to, const Vec3<double>& normal) {
  const bool beside =
      Dot(Cross(normal, from), d) >= 0 && Dot(Cross(to, normal), d) >= 0;
  if (beside) return std::asin(std::min(1.0, std::abs(Dot(normal, d))));
  return std::min(AngleBetween(d, from), AngleBetween(d, to));
}

}  // namespace

ViewEdges::ViewEdges(const ContourQuery& query, int facet)
    : query_(query),
      view_(ViewOf(query)),
      exact_(view_),
      interval_(view_),
      facet_(facet),
      source_triangle_(query.scene.facets()[Index(facet)].first_triangle) {
  const Facet& source = query.scene.facets()[Index(facet)];
  for (const Triangle& triangle : TrianglesOf(query.scene, source))
    source_caps_.push_back(CapOf(triangle));
  const IdVector<FacetId, bool> ignored = IgnoredFacets(query);
  std::vector<int> relevant;
  for (int t = 0; t < static_cast<int>(view_.triangles.size()); ++t) {
    const FacetId own = FacetOf(view_.triangles[TriangleId(t)]);
    if (!ignored.empty() && ignored[own]) continue;
    if (Relevant(t)) relevant.push_back(t);
  }
  AddSceneEdges(relevant);
  for (const int t : relevant)
    AddCut(t);
}

/// Around the direction to the first corner. In double, which is off by far
/// less than kBeside.
ViewEdges::Cap ViewEdges::CapOf(const Triangle& triangle) const {
  std::array<Vec3<double>, 3> units{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = view_.vertices[VertexId(triangle.vertices[k])];
    const Point3& r = view_.position;
    units[k] = UnitOf(Vec3<double>{p.x - r.x, p.y - r.y, p.z - r.z});
  }
  return {units[0], std::max(AngleBetween(units[0], units[1]),
                             AngleBetween(units[0], units[2]))};
}

bool ViewEdges::IsBesideSource(const Triangle& triangle) const {
  const Cap cap = CapOf(triangle);
  return !cap.IsWide() && std::ranges::all_of(source_caps_, [&](const Cap& s) {
    return !s.IsWide() &&
           LeastAngle(cap.center, s.center, cap.radius + s.radius) > kBeside;
  });
}

Exact ViewEdges::AbovePlane(int vertex) const {
  return exact_.AboveTriangle(TriangleId(source_triangle_), VertexId(vertex));
}

Sign ViewEdges::SideOfPlane(int vertex) const {
  {
    const RoundUpward rounding;
    const auto sign = TrySign(interval_.AboveTriangle(
        TriangleId(source_triangle_), VertexId(vertex)));
    if (sign) return *sign;
  }
  return SignOf(AbovePlane(vertex));
}

/// The side of a vertex to the plane through r, a and b.
Sign ViewEdges::SideOfEdge(int a, int b, int vertex) const {
  {
    const RoundUpward rounding;
    const auto sign =
        TrySign(Determinant(interval_.FromReceiver(VertexId(a)),
                            interval_.FromReceiver(VertexId(b)),
                            interval_.FromReceiver(VertexId(vertex))));
    if (sign) return *sign;
  }
  return SignOf(Determinant(exact_.FromReceiver(VertexId(a)),
                            exact_.FromReceiver(VertexId(b)),
                            exact_.FromReceiver(VertexId(vertex))));
}

int ViewEdges::FaceOf(int facet) const {
  return query_.scene.facets()[Index(facet)].face + 1;
}

/// Of the source itself, or a triangle that blocks it somewhere (its plane
/// not through r, some part strictly in front, or coplanar and earlier).
bool ViewEdges::Relevant(int triangle) const {
  const Triangle& t = view_.triangles[TriangleId(triangle)];
  if (t.facet == facet_) return true;
  if (IsBesideSource(t)) return false;
  bool any_front = false;
  bool all_on = true;
  for (const int v : t.vertices) {
    const Sign side = SideOfPlane(v);
    any_front = any_front || side == Sign::kPositive;
    all_on = all_on && side == Sign::kZero;
  }
  const auto facets = query_.scene.facets();
  const bool earlier = facets[Index(t.facet)].face < facets[Index(facet_)].face;
  if (!any_front && !(all_on && earlier)) return false;
  return SignOf(exact_.Height(TriangleId(triangle))) != Sign::kZero;
}

void ViewEdges::AddSceneEdges(const std::vector<int>& relevant) {
  // Per edge: the triangles on it, with the side of their third corner.
  struct Neighbour {
    int facet;
    Sign side;
  };

  std::map<std::pair<int, int>, std::vector<Neighbour>> neighbours;
  for (const int t : relevant) {
    const Triangle& triangle = view_.triangles[TriangleId(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] =
          std::minmax(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
      const Sign side = SideOfEdge(a, b, triangle.vertices[(k + 2) % 3]);
      neighbours[{a, b}].push_back({triangle.facet, side});
    }
  }
  for (const auto& [key, sides] : neighbours) {
    const auto inner = [&sides = sides, this](const Neighbour& n) {
      return std::ranges::any_of(sides, [&](const Neighbour& other) {
        const bool diagonal = n.facet == other.facet;
        const bool both_block = n.facet != facet_ && other.facet != facet_;
        return (diagonal || both_block) &&
               n.side * other.side == Sign::kNegative;
      });
    };
    if (std::ranges::all_of(sides, inner)) continue;
    int face = FaceOf(sides.front().facet);
    for (const Neighbour& neighbour : sides)
      face = std::min(face, FaceOf(neighbour.facet));
    AddEdge(VertexRecipe(key.first), VertexRecipe(key.second), key.first,
            key.second, {face, key.first, key.second, 0});
  }
}

/// The line where a blocker meets the source's plane, if it crosses it.
void ViewEdges::AddCut(int triangle) {
  const Triangle& t = view_.triangles[TriangleId(triangle)];
  if (t.facet == facet_) return;
  std::array<Sign, 3> side{};
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = SideOfPlane(t.vertices[k]);
  }
  std::vector<std::pair<DirectionRecipe, int>> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const int a = t.vertices[k];
    const int b = t.vertices[next];
    if (side[k] == Sign::kZero) ends.emplace_back(VertexRecipe(a), a);
    if (side[k] * side[next] == Sign::kNegative) {
      const bool a_in_front = side[k] == Sign::kPositive;
      ends.emplace_back(
          DirectionRecipe::EdgeAtPlane(VertexId(a_in_front ? a : b),
                                       VertexId(a_in_front ? b : a),
                                       TriangleId(source_triangle_)),
          -1);
    }
  }
  const bool crosses = std::ranges::count(side, Sign::kPositive) > 0 &&
                       std::ranges::count(side, Sign::kNegative) > 0 &&
                       ends.size() == 2;
  if (!crosses) return;
  AddEdge(ends[0].first, ends[1].first, ends[0].second, ends[1].second,
          {FaceOf(t.facet), -1, -1, FaceOf(facet_)});
}

void ViewEdges::AddEdge(const DirectionRecipe& from, const DirectionRecipe& to,
                        int a, int b, const SeenEdge& seen) {
  Vec3<Interval> u;
  Vec3<Interval> v;
  Vec3<Interval> plane;
  {
    const RoundUpward rounding;
    u = interval_.Direction(from, {}, {});
    v = interval_.Direction(to, {}, {});
    plane = Cross(u, v);
  }
  const Vec3<double> from_unit = UnitOf(u);
  const Vec3<double> to_unit = UnitOf(v);
  edges_.push_back({plane, from, to, a, b, seen, from_unit, to_unit,
                    AngleBetween(from_unit, to_unit),
                    from.kind() == DirectionRecipe::Kind::kVertex &&
                        to.kind() == DirectionRecipe::Kind::kVertex});
}

/// Whether the point weight_a a + weight_b b of a scene edge is in front of
/// the source's plane or on it; a cut is on it.
bool ViewEdges::InFront(const Edge& edge, const Exact& weight_a,
                        const Exact& weight_b) const {
  if (edge.from.kind() != DirectionRecipe::Kind::kVertex ||
      edge.to.kind() != DirectionRecipe::Kind::kVertex) {
    return true;
  }
  return SignOf(weight_a * AbovePlane(edge.a) +
                weight_b * AbovePlane(edge.b)) != Sign::kNegative;
}

std::optional<ViewEdges::Hit> ViewEdges::HitOf(const Edge& edge,
                                               const Vec3<Exact>& d) const {
  const Vec3<Exact> u = exact_.Direction(edge.from, {}, {});
  const Vec3<Exact> v = exact_.Direction(edge.to, {}, {});
  const Vec3<Exact> plane = Cross(u, v);
  if (SignOf(Dot(plane, d)) != Sign::kZero) return std::nullopt;
  // d is a positive multiple of weight_u u + weight_v v.
  const Exact weight_u = Dot(Cross(d, v), plane);
  const Exact weight_v = Dot(Cross(u, d), plane);
  const Sign at_u = SignOf(weight_u);
  const Sign at_v = SignOf(weight_v);
  if (at_u == Sign::kNegative || at_v == Sign::kNegative) return std::nullopt;
  if (!InFront(edge, weight_u, weight_v)) return std::nullopt;
  const int vertex = at_v == Sign::kZero   ? edge.a
                     : at_u == Sign::kZero ? edge.b
                                           : -1;
  return Hit{plane, vertex, edge.seen};
}

std::vector<ViewEdges::Hit> ViewEdges::Through(const Vec3<Exact>& d) const {
  std::vector<Hit> hits;
  const Vec3<Interval> rough{FromExact<Interval>::Of(d.x),
                             FromExact<Interval>::Of(d.y),
                             FromExact<Interval>::Of(d.z)};
  const Vec3<double> unit = UnitOf(d);
  for (const Edge& edge : edges_) {
    // Far more than the units can be off.
    constexpr double kSurelyApart = 1e-6;
    if (edge.has_sure_ends &&
        LeastAngle(unit, edge.from_unit, edge.length) > kSurelyApart) {
      continue;
    }
    {
      const RoundUpward rounding;
      const auto sign = TrySign(Dot(edge.plane, rough));
      if (sign && *sign != Sign::kZero) continue;
    }
    if (auto hit = HitOf(edge, d)) hits.push_back(std::move(*hit));
  }
  return hits;
}

std::optional<ViewEdges::Miss> ViewEdges::Nearest(const Vec3<Exact>& d) const {
  // What looks nearer than this is measured again from exact numbers.
  constexpr double kClose = 1e-6;
  const Vec3<double> unit = UnitOf(d);
  std::optional<Miss> nearest;
  for (const Edge& edge : edges_) {
    if (nearest && LeastAngle(unit, edge.from_unit, edge.length) >
                       nearest->angle + kClose) {
      continue;
    }
    const Vec3<double> cross = Cross(edge.from_unit, edge.to_unit);
    const double length = Length(cross);
    const Vec3<double> normal = length > 0 ? 1 / length * cross : cross;
    double angle = AngleToArc(unit, edge.from_unit, edge.to_unit, normal);
    if (nearest && angle > nearest->angle + kClose) continue;
    if (angle < kClose) {
      if (HitOf(edge, d)) continue;
      const Vec3<Exact> plane = Cross(exact_.Direction(edge.from, {}, {}),
                                      exact_.Direction(edge.to, {}, {}));
      const Exact height = Dot(plane, d);
      const double size = std::sqrt(CGAL::to_double(Dot(plane, plane)) *
                                    CGAL::to_double(Dot(d, d)));
      const double sine = std::abs(CGAL::to_double(height)) / size;
      const double to_ends = std::min(AngleBetween(unit, edge.from_unit),
                                      AngleBetween(unit, edge.to_unit));
      // Beside the edge its plane is near; beyond its ends they are.
      const bool beside = to_ends > kClose || angle < to_ends;
      angle = beside && sine > 0 ? sine : to_ends;
      if (!(angle > 0) || !std::isfinite(angle)) continue;
    }
    if (!nearest || angle < nearest->angle) nearest = Miss{edge.seen, angle};
  }
  return nearest;
}

}  // namespace truelux
