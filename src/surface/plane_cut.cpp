// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/plane_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "exact/primitive.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

/// A place of P, or the foot on P of a point of space.
struct Place {
  mpq_class x;
  mpq_class y;
};

bool IsNothing(const RationalVector& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

RationalVector NormalOf(const Scene& scene, const Triangle& triangle) {
  const auto at = [&](std::size_t k) {
    return RationalOf(
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
  };
  const RationalVector a = at(0);
  return Cross(at(1) - a, at(2) - a);
}

/// The heights of vertices over P as signs, in double where that is certain.
class SidesOfPlane {
 public:
  explicit SidesOfPlane(const EdgePlane& plane)
      : normal_(RationalOf(plane.normal)), offset_(plane.offset) {
    const Vector3 n = ToDouble(plane.normal);
    near_normal_ = {n.x, n.y, n.z};
    const mpq_class largest =
        std::max({mpq_class(abs(normal_.x)), mpq_class(abs(normal_.y)),
                  mpq_class(abs(normal_.z))});
    near_offset_ = NearestTo(mpq_class(offset_ / largest));
  }

  [[nodiscard]] int Of(const Point3& p) const {
    const double x = near_normal_.x * p.x;
    const double y = near_normal_.y * p.y;
    const double z = near_normal_.z * p.z;
    const double height = x + y + z - near_offset_;
    const double size =
        std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(near_offset_);
    // Each term is off by a few ulps.
    if (std::fabs(height) > 0x1p-48 * size + 0x1p-900 && std::isfinite(size))
      return height > 0 ? 1 : -1;
    return sgn(HeightOf(RationalOf(p)));
  }

  [[nodiscard]] mpq_class HeightOf(const RationalVector& p) const {
    return Dot(normal_, p) - offset_;
  }

 private:
  RationalVector normal_;
  mpq_class offset_;
  Vec3<double> near_normal_{};
  double near_offset_ = 0;
};

class Cutter {
 public:
  Cutter(const Scene& scene, const EdgePlane& plane, const CutAxes& axes)
      : scene_(scene),
        sides_of_plane_(plane),
        along_(mpq_class(1 / Dot(axes.along, axes.along)) * axes.along),
        up_(mpq_class(1 / Dot(axes.up, axes.up)) * axes.up) {
    cut_.axes = axes;
    for (const Point3& p : scene.vertices())
      sides_.push_back(sides_of_plane_.Of(p));
  }

  /// Whether a facet that emits meets P in more than a point, perhaps below the
  /// trace.
  [[nodiscard]] bool HasLight() const {
    return std::ranges::any_of(
        scene_.triangles(), [this](const Triangle& triangle) {
          const Facet& facet =
              scene_.facets()[static_cast<std::size_t>(triangle.facet)];
          return Emits(scene_.faces()[static_cast<std::size_t>(facet.face)]) &&
                 MeetingOf(triangle) != Meeting::kNone;
        });
  }

  void AddTriangles() {
    for (const Triangle& triangle : scene_.triangles()) {
      const Meeting meeting = MeetingOf(triangle);
      if (meeting == Meeting::kFlat) AddFlat(triangle);
      if (meeting == Meeting::kLine) AddFacet(triangle);
    }
  }

  void AddEdges(const EdgePlanes& planes, const EdgePlane& plane) {
    for (const int line : plane.lines) {
      for (const int index :
           planes.edges_of_line[static_cast<std::size_t>(line)]) {
        const auto& ends = planes.edges[static_cast<std::size_t>(index)].ends;
        const auto segment = SegmentOf(PlaceOf(ends[0]), PlaceOf(ends[1]));
        if (segment) cut_.edges.push_back({ends, *segment});
      }
    }
  }

  PlaneCut Take() { return std::move(cut_); }

 private:
  /// How a triangle meets P.
  enum class Meeting { kNone, kLine, kFlat };

  [[nodiscard]] Meeting MeetingOf(const Triangle& triangle) const {
    int zeros = 0;
    bool is_above = false;
    bool is_below = false;
    for (const int vertex : triangle.vertices) {
      const int side = SideOf(vertex);
      if (side == 0) ++zeros;
      is_above = is_above || side > 0;
      is_below = is_below || side < 0;
    }
    if (zeros == 3) return Meeting::kFlat;
    return zeros == 2 || (is_above && is_below) ? Meeting::kLine
                                                : Meeting::kNone;
  }

  [[nodiscard]] int SideOf(int vertex) const {
    return sides_[static_cast<std::size_t>(vertex)];
  }

  [[nodiscard]] RationalVector VertexAt(int vertex) const {
    return RationalOf(scene_.vertices()[static_cast<std::size_t>(vertex)]);
  }

  /// The place of a vertex, or of its foot.
  const Place& PlaceOf(int vertex) {
    const auto [entry, is_new] = places_.try_emplace(vertex);
    if (is_new) {
      const RationalVector v = VertexAt(vertex) - cut_.axes.from;
      entry->second = {Dot(v, along_), Dot(v, up_)};
    }
    return entry->second;
  }

  /// Where P crosses the line through two vertices on different sides.
  Place CrossingOf(int a, int b) {
    const mpq_class at_a = sides_of_plane_.HeightOf(VertexAt(a));
    const mpq_class at_b = sides_of_plane_.HeightOf(VertexAt(b));
    const mpq_class share = at_a / (at_a - at_b);
    const Place& from = PlaceOf(a);
    const Place& to = PlaceOf(b);
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  }

  int LineThrough(const Place& p, const Place& q) {
    const mpq_class dx = q.x - p.x;
    const mpq_class dy = q.y - p.y;
    CutLine line;
    if (dy == 0) {
      line = {true, 1, p.y};
    } else {
      const mpq_class b = -dx / dy;
      line = {false, b, p.x + b * p.y};
    }
    const int next = static_cast<int>(cut_.lines.size());
    const int index =
        lines_.try_emplace({line.is_level, line.b, line.c}, next).first->second;
    if (index == next) cut_.lines.push_back(std::move(line));
    return index;
  }

  int PointOf(const Place& place, int line) {
    CutPoint point{place.x / place.y, 1 / place.y, {}};
    const int next = static_cast<int>(cut_.points.size());
    const int index =
        indices_.try_emplace({point.p, point.z}, next).first->second;
    if (index == next) cut_.points.push_back(std::move(point));
    std::vector<int>& lines =
        cut_.points[static_cast<std::size_t>(index)].lines;
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
    return index;
  }

  /// The part above the trace, if there is one.
  std::optional<CutSegment> SegmentOf(const Place& p, const Place& q) {
    if (p.y <= 0 && q.y <= 0) return std::nullopt;
    CutSegment segment;
    segment.line = LineThrough(p, q);
    segment.ends = {p.y > 0 ? PointOf(p, segment.line) : kOnTrace,
                    q.y > 0 ? PointOf(q, segment.line) : kOnTrace};
    return segment;
  }

  void AddFacet(const Triangle& triangle) {
    std::array<int, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k)
      sides[k] = SideOf(triangle.vertices[k]);
    std::vector<Place> places;
    int side = 0;
    bool is_crossed = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (sides[k] == 0) places.push_back(PlaceOf(triangle.vertices[k]));
      if (sides[k] * sides[next] < 0) {
        places.push_back(
            CrossingOf(triangle.vertices[k], triangle.vertices[next]));
        is_crossed = true;
      }
      side += sides[k];
    }
    if (is_crossed) side = 0;
    if (places[0].y == 0 && places[1].y == 0) AddContact(triangle, places);
    const auto segment = SegmentOf(places[0], places[1]);
    if (!segment) return;
    const CutLine& line = cut_.lines[static_cast<std::size_t>(segment->line)];
    const RationalVector normal = NormalOf(scene_, triangle);
    const mpq_class scale =
        Dot(normal, line.is_level ? cut_.axes.up : cut_.axes.along);
    cut_.facets.push_back({triangle.facet, *segment, side, sgn(scale),
                           Dot(normal, cut_.axes.normal) / scale, false,
                           false});
  }

  /// Of a triangle that meets the surface along the trace: receivers there lie
  /// on it, if it stands above the surface.
  void AddContact(const Triangle& triangle, const std::vector<Place>& places) {
    const bool is_above =
        std::ranges::any_of(triangle.vertices, [&](int vertex) {
          return Dot(cut_.axes.surface, VertexAt(vertex) - cut_.axes.from) > 0;
        });
    if (!is_above) return;
    cut_.contacts.push_back({std::min(places[0].x, places[1].x),
                             std::max(places[0].x, places[1].x)});
  }

  void AddFlat(const Triangle& triangle) {
    CutFlat flat;
    flat.facet = triangle.facet;
    flat.front_side = sgn(Dot(NormalOf(scene_, triangle), cut_.axes.normal));
    std::vector<mpq_class> on_trace;
    for (std::size_t k = 0; k < 3; ++k) {
      const Place& p = PlaceOf(triangle.vertices[k]);
      const Place& q = PlaceOf(triangle.vertices[(k + 1) % 3]);
      if (p.y == 0) on_trace.push_back(p.x);
      if (sgn(p.y) * sgn(q.y) < 0)
        on_trace.emplace_back(p.x + p.y / (p.y - q.y) * (q.x - p.x));
      if (const auto side = SegmentOf(p, q)) flat.sides.push_back(*side);
    }
    if (flat.sides.empty()) return;
    if (on_trace.size() > 1) {
      const auto [least, most] = std::ranges::minmax(on_trace);
      cut_.contacts.push_back({least, most});
    }
    cut_.flats.push_back(std::move(flat));
  }

  const Scene& scene_;
  SidesOfPlane sides_of_plane_;
  RationalVector along_;    ///< x is this times what lies beyond axes.from
  RationalVector up_;       ///< likewise y
  std::vector<int> sides_;  ///< of all vertices
  std::map<int, Place> places_;
  std::map<std::pair<mpq_class, mpq_class>, int> indices_;  ///< of points
  std::map<std::tuple<bool, mpq_class, mpq_class>, int> lines_;
  PlaneCut cut_;
};

}  // namespace

RationalVector CutAxes::PointAt(const mpq_class& x) const {
  return from + x * along;
}

CutAxes CutAxesOf(const Scene& scene, const SurfaceFrame& frame,
                  const EdgePlane& plane, const RationalVector& from,
                  const RationalVector& to, bool reversed_side) {
  const Face& first =
      scene.faces()[static_cast<std::size_t>(frame.faces.front())];
  const Facet& facet =
      scene.facets()[static_cast<std::size_t>(first.first_facet)];
  CutAxes axes;
  axes.surface = NormalOf(
      scene, scene.triangles()[static_cast<std::size_t>(facet.first_triangle)]);
  if (reversed_side) axes.surface = -axes.surface;
  axes.normal = RationalOf(plane.normal);
  axes.from = from;
  axes.along = to - from;
  axes.up = Cross(axes.normal, axes.along);
  const mpq_class rise = Dot(axes.up, axes.surface);
  if (IsNothing(axes.along) || rise == 0 ||
      Dot(axes.normal, from) != plane.offset ||
      Dot(axes.normal, axes.along) != 0 ||
      Dot(axes.surface, from - frame.origin) != 0 ||
      Dot(axes.surface, axes.along) != 0) {
    throw std::invalid_argument("two points are not those of a trace");
  }
  if (rise < 0) axes.up = -axes.up;
  return axes;
}

PlaneCut PlaneCutOf(const Scene& scene, const EdgePlanes& planes,
                    std::size_t plane_index, const CutAxes& axes) {
  const EdgePlane& plane = planes.planes.at(plane_index);
  Cutter cutter(scene, plane, axes);
  if (cutter.HasLight()) {
    cutter.AddTriangles();
    cutter.AddEdges(planes, plane);
  }
  return cutter.Take();
}

}  // namespace truelux
