// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/plain_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "exact/exact_conversion.h"

namespace truelux::testing {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

bool IsZero(const RationalVector& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

RationalVector Sum(const RationalVector& a, const RationalVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// The normal divided by its first component that is not zero.
std::array<mpq_class, 3> PlaneKey(const RationalVector& n) {
  const mpq_class& first = n.x != 0 ? n.x : (n.y != 0 ? n.y : n.z);
  if (first == 0) return {};
  return {n.x / first, n.y / first, n.z / first};
}

/// An angle that is not 0, also where its double is.
double NotZero(double angle) {
  return std::max(angle, std::numeric_limits<double>::denorm_min());
}

/// The angle between two directions; 0 only if they are equal.
double AngleOf(const RationalVector& a, const RationalVector& b) {
  const RationalVector cross = Cross(a, b);
  const mpq_class cosine = Dot(a, b);
  if (IsZero(cross) && cosine > 0) return 0;
  return NotZero(
      std::atan2(std::sqrt(Dot(cross, cross).get_d()), cosine.get_d()));
}

/// The angle from d to the arc between two directions; 0 only if d is on it.
double AngleToArc(const RationalVector& d, const RationalVector& from,
                  const RationalVector& to) {
  const RationalVector n = Cross(from, to);
  const bool is_beside =
      Dot(Cross(n, from), d) >= 0 && Dot(Cross(to, n), d) >= 0;
  if (!is_beside) return std::min(AngleOf(d, from), AngleOf(d, to));
  const mpq_class height = Dot(n, d);
  if (height == 0) return 0;
  const mpq_class square = height * height / (Dot(n, n) * Dot(d, d));
  return NotZero(std::asin(std::sqrt(square.get_d())));
}

}  // namespace

bool operator<(const PlainHit& a, const PlainHit& b) {
  return std::tie(a.edge, a.vertex, a.plane) <
         std::tie(b.edge, b.vertex, b.plane);
}

PlainHit PlainHitOf(const EdgeHit& hit) {
  const RationalVector n{RationalOf(hit.plane.x), RationalOf(hit.plane.y),
                         RationalOf(hit.plane.z)};
  return {hit.edge, hit.vertex.value(), PlaneKey(n)};
}

PlainEdges::PlainEdges(const ContourQuery& query)
    : query_(query), r_(RationalOf(query.receiver.position)) {
  const IdVector<FacetId, bool> ignored = IgnoredFacets(query);
  const auto triangles = query.scene.triangles();
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (!ignored.empty() && ignored[FacetId(At(t).facet)]) continue;
    if (Dot(Normal(t), Corner(t, 0) - r_) != 0) triangles_.push_back(t);
  }
}

const Triangle& PlainEdges::At(int triangle) const {
  return query_.scene.triangles()[Index(triangle)];
}

RationalVector PlainEdges::Vertex(int v) const {
  return RationalOf(query_.scene.vertices()[Index(v)]);
}

RationalVector PlainEdges::Corner(int triangle, std::size_t k) const {
  return Vertex(At(triangle).vertices[k % 3]);
}

RationalVector PlainEdges::Normal(int triangle) const {
  return Cross(Corner(triangle, 1) - Corner(triangle, 0),
               Corner(triangle, 2) - Corner(triangle, 0));
}

int PlainEdges::FaceNumber(int triangle) const {
  return query_.scene.facets()[Index(At(triangle).facet)].face + 1;
}

bool PlainEdges::TakesPart(int facet) const {
  return std::ranges::any_of(triangles_,
                             [&](int t) { return At(t).facet == facet; });
}

bool PlainEdges::Meets(int facet, const RationalVector& d) const {
  return std::ranges::any_of(triangles_, [&](int t) {
    if (At(t).facet != facet) return false;
    const auto p = PointInPlane(t, d);
    return p && Holds(t, *p);
  });
}

/// 1 if a point is on the receiver's side of a facet's plane, 0 if it is on the
/// plane.
int PlainEdges::SideOfPlane(int facet, const RationalVector& p) const {
  const int t = query_.scene.facets()[Index(facet)].first_triangle;
  const RationalVector n = Normal(t);
  return sgn(Dot(n, p - Corner(t, 0))) * sgn(Dot(n, r_ - Corner(t, 0)));
}

bool PlainEdges::CanHide(int triangle, int facet) const {
  bool all_on = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = SideOfPlane(facet, Corner(triangle, k));
    if (side > 0) return true;
    all_on = all_on && side == 0;
  }
  const int t = query_.scene.facets()[Index(facet)].first_triangle;
  return all_on && FaceNumber(triangle) < FaceNumber(t);
}

std::vector<int> PlainEdges::Relevant(int facet) const {
  std::vector<int> relevant;
  for (const int t : triangles_) {
    if (At(t).facet == facet || CanHide(t, facet)) relevant.push_back(t);
  }
  return relevant;
}

std::vector<PlainEdges::Side> PlainEdges::SidesOf(
    const std::vector<int>& triangles) const {
  std::vector<Side> sides;
  for (const int t : triangles) {
    const auto& v = At(t).vertices;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(v[k], v[(k + 1) % 3]);
      sides.push_back({t, a, b, v[(k + 2) % 3]});
    }
  }
  return sides;
}

/// Whether two triangles have an edge in common and lie, as seen, on different
/// sides of it.
bool PlainEdges::AreBeyondEachOther(const Side& s, const Side& t) const {
  if (s.a != t.a || s.b != t.b) return false;
  const RationalVector n = Cross(Vertex(s.a) - r_, Vertex(s.b) - r_);
  return sgn(Dot(n, Vertex(s.third) - r_)) * sgn(Dot(n, Vertex(t.third) - r_)) <
         0;
}

/// The sides of relevant triangles beyond which neither the same facet nor, if
/// the triangle hides, another one that does goes on.
std::vector<PlainEdges::Side> PlainEdges::BoundsOf(int facet) const {
  const std::vector<Side> sides = SidesOf(Relevant(facet));
  std::vector<Side> bounds;
  for (const Side& own : sides) {
    const int f = At(own.triangle).facet;
    const bool goes_on = std::ranges::any_of(sides, [&](const Side& other) {
      const int g = At(other.triangle).facet;
      return (f == g || (f != facet && g != facet)) &&
             AreBeyondEachOther(own, other);
    });
    if (!goes_on) bounds.push_back(own);
  }
  return bounds;
}

/// Where the ray along d meets an edge.
std::optional<RationalVector> PlainEdges::PointOn(
    const Side& side, const RationalVector& d) const {
  const RationalVector a = Vertex(side.a);
  const RationalVector along = Vertex(side.b) - a;
  // a + t along - r is a multiple of d: Cross(., d) = 0, line by line.
  const RationalVector slope = Cross(along, d);
  const RationalVector value = Cross(a - r_, d);
  mpq_class t;
  if (slope.x != 0) {
    t = -value.x / slope.x;
  } else if (slope.y != 0) {
    t = -value.y / slope.y;
  } else if (slope.z != 0) {
    t = -value.z / slope.z;
  } else {
    return std::nullopt;  // along the ray: the plane would hold r
  }
  if (t < 0 || t > 1) return std::nullopt;
  const RationalVector p = Sum(a, t * along);
  if (!IsZero(Cross(p - r_, d)) || Dot(p - r_, d) <= 0) return std::nullopt;
  return p;
}

std::optional<RationalVector> PlainEdges::PointInPlane(
    int triangle, const RationalVector& d) const {
  const RationalVector n = Normal(triangle);
  const mpq_class speed = Dot(n, d);
  if (speed == 0) return std::nullopt;
  const mpq_class s = Dot(n, Corner(triangle, 0) - r_) / speed;
  if (s <= 0) return std::nullopt;
  return Sum(r_, s * d);
}

/// Whether a point of its plane is in a triangle, border included.
bool PlainEdges::Holds(int triangle, const RationalVector& p) const {
  const RationalVector n = Normal(triangle);
  if (Dot(n, p - Corner(triangle, 0)) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalVector side = Corner(triangle, k + 1) - Corner(triangle, k);
    if (Dot(n, Cross(side, p - Corner(triangle, k))) < 0) return false;
  }
  return true;
}

/// The one of some vertices that is a point, or -1.
int PlainEdges::VertexAt(const RationalVector& p,
                         std::span<const int> vertices) const {
  const auto found = std::ranges::find_if(
      vertices, [&](int v) { return IsZero(Vertex(v) - p); });
  return found == vertices.end() ? -1 : *found;
}

PlainHit PlainEdges::HitOf(const Side& side, const RationalVector& p,
                           const std::vector<Side>& named) const {
  int face = FaceNumber(side.triangle);
  for (const Side& other : named) {
    if (other.a == side.a && other.b == side.b)
      face = std::min(face, FaceNumber(other.triangle));
  }
  const RationalVector n = Cross(Vertex(side.a) - r_, Vertex(side.b) - r_);
  return {{face, side.a, side.b, 0},
          VertexAt(p, std::array{side.a, side.b}),
          PlaneKey(n)};
}

std::optional<PlainHit> PlainEdges::CutAt(int triangle, int facet,
                                          const RationalVector& d) const {
  if (CutEnds(triangle, facet).empty()) return std::nullopt;
  const int source = query_.scene.facets()[Index(facet)].first_triangle;
  const auto p = PointInPlane(source, d);
  if (!p || !Holds(triangle, *p)) return std::nullopt;
  const RationalVector line = Cross(Normal(triangle), Normal(source));
  return PlainHit{{FaceNumber(triangle), -1, -1, FaceNumber(source)},
                  VertexAt(*p, At(triangle).vertices),
                  PlaneKey(Cross(line, *p - r_))};
}

/// The ends of the segment in which a triangle crosses a facet's plane; none if
/// it does not have points on both sides.
std::vector<RationalVector> PlainEdges::CutEnds(int triangle, int facet) const {
  std::vector<RationalVector> ends;
  if (At(triangle).facet == facet) return ends;
  const int source = query_.scene.facets()[Index(facet)].first_triangle;
  const RationalVector n = Normal(source);
  bool crosses = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalVector p = Corner(triangle, k);
    const RationalVector q = Corner(triangle, k + 1);
    const mpq_class at_p = Dot(n, p - Corner(source, 0));
    const mpq_class at_q = Dot(n, q - Corner(source, 0));
    if (at_p == 0) ends.push_back(p);
    if (sgn(at_p) * sgn(at_q) >= 0) continue;
    crosses = true;
    const mpq_class t = at_p / (at_p - at_q);
    ends.push_back(Sum(p, t * (q - p)));
  }
  // An edge from one side to the other; else the triangle stays on one.
  if (!crosses) ends.clear();
  return ends;
}

std::set<PlainHit> PlainEdges::OfSource(int facet, const RationalVector& d,
                                        NamedBy named_by) const {
  const std::vector<int> relevant = Relevant(facet);
  const std::vector<Side> named =
      SidesOf(named_by == NamedBy::kView ? triangles_ : relevant);
  std::set<PlainHit> hits;
  for (const Side& side : BoundsOf(facet)) {
    const auto p = PointOn(side, d);
    if (p && SideOfPlane(facet, *p) >= 0) hits.insert(HitOf(side, *p, named));
  }
  for (const int t : relevant) {
    if (auto cut = CutAt(t, facet, d)) hits.insert(*std::move(cut));
  }
  return hits;
}

/// The segment in which two triangles cross, if the ray meets it.
std::optional<PlainHit> PlainEdges::MeetingAt(int s, int t,
                                              const RationalVector& d) const {
  if (FaceNumber(s) == FaceNumber(t)) return std::nullopt;
  const auto p = PointInPlane(s, d);
  const RationalVector line = Cross(Normal(s), Normal(t));
  if (!p || !Holds(s, *p) || !Holds(t, *p) || IsZero(line)) return std::nullopt;
  int shared = 0;
  for (const int v : At(s).vertices)
    shared += static_cast<int>(std::ranges::count(At(t).vertices, v));
  if (shared > 1) return std::nullopt;
  // How far p + x line stays in both triangles, forth (sense 1) and back (-1):
  // a little, unless an edge through p keeps it out.
  const auto goes = [&](const mpq_class& sense) {
    const RationalVector step = sense * line;
    for (const int triangle : {s, t}) {
      const RationalVector n = Normal(triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        const RationalVector side =
            Corner(triangle, k + 1) - Corner(triangle, k);
        const bool is_on_edge =
            Dot(n, Cross(side, *p - Corner(triangle, k))) == 0;
        if (is_on_edge && Dot(n, Cross(side, step)) < 0) return false;
      }
    }
    return true;
  };
  const bool forth = goes(1);
  const bool back = goes(-1);
  if (!forth && !back) return std::nullopt;
  const int face = FaceNumber(s);
  const int other = FaceNumber(t);
  const int corner =
      std::max(VertexAt(*p, At(s).vertices), VertexAt(*p, At(t).vertices));
  return PlainHit{{std::min(face, other), -1, -1, std::max(face, other)},
                  forth && back ? -1 : corner,
                  PlaneKey(Cross(line, *p - r_))};
}

std::set<PlainHit> PlainEdges::NotBehind(int facet,
                                         const RationalVector& d) const {
  const auto is_behind = [&](const RationalVector& p) {
    return facet >= 0 && SideOfPlane(facet, p) < 0;
  };
  const std::vector<Side> sides = SidesOf(triangles_);
  const auto goes_on = [&](const Side& own) {
    return std::ranges::any_of(sides, [&](const Side& other) {
      return FaceNumber(own.triangle) == FaceNumber(other.triangle) &&
             AreBeyondEachOther(own, other);
    });
  };
  std::set<PlainHit> hits;
  std::set<std::array<mpq_class, 3>> planes;
  for (const Side& side : sides) {
    const auto p = PointOn(side, d);
    if (!p) continue;
    const PlainHit hit = HitOf(side, *p, sides);
    planes.insert(hit.plane);
    if (!is_behind(*p) && !goes_on(side)) hits.insert(hit);
  }
  for (const int s : triangles_) {
    for (const int t : triangles_) {
      auto meeting = MeetingAt(s, t, d);
      if (!meeting || planes.contains(meeting->plane)) continue;
      if (!is_behind(*PointInPlane(s, d))) hits.insert(*std::move(meeting));
    }
  }
  return hits;
}

bool PlainEdges::PassesBehind(int facet, const RationalVector& d) const {
  return std::ranges::any_of(BoundsOf(facet), [&](const Side& side) {
    const auto p = PointOn(side, d);
    return p && SideOfPlane(facet, *p) < 0;
  });
}

std::optional<double> PlainEdges::NearestAngle(int facet,
                                               const RationalVector& d) const {
  std::optional<double> nearest;
  const auto add = [&](const RationalVector& from, const RationalVector& to) {
    const double angle = AngleToArc(d, from - r_, to - r_);
    if (angle > 0 && (!nearest || angle < *nearest)) nearest = angle;
  };
  for (const Side& side : BoundsOf(facet))
    add(Vertex(side.a), Vertex(side.b));
  for (const int t : Relevant(facet)) {
    const auto ends = CutEnds(t, facet);
    if (!ends.empty()) add(ends[0], ends[1]);
  }
  return nearest;
}

}  // namespace truelux::testing
