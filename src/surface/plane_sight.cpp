// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/plane_sight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace truelux {
namespace {

/// Lengths below this share of those around them are taken as 0.
constexpr double kTiny = 1e-9;
/// Finite directions are below it.
constexpr double kHuge = 1e300;

Vec3<double> VectorOf(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

double LengthOf(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

Vec3<double> UnitOf(const Vec3<double>& v) {
  return (1 / LengthOf(v)) * v;
}

Point3 Between(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          a.z + share * (b.z - a.z)};
}

}  // namespace

PlaneSight::PlaneSight(std::span<const PlaneEdge> edges,
                       std::span<const SourceTriangle> sources,
                       const Vec3<double>& normal, const Vec3<double>& up,
                       const Point3& at)
    : up_(UnitOf(up)), along_(UnitOf(Cross(normal, up))), at_(at) {
  for (const PlaneEdge& edge : edges) {
    const Segment segment = {PlaceOf(edge.ends[0]), PlaceOf(edge.ends[1])};
    if (segment[0].y > 0 || segment[1].y > 0)
      edges_.push_back({segment, edge.line});
  }
  if (edges_.size() < 2) return;
  for (const SourceTriangle& source : sources)
    AddSource(source, UnitOf(normal), edges[0].ends[0]);
}

PlaneSight::Place PlaneSight::PlaceOf(const Point3& p) const {
  const Vec3<double> v = VectorOf(at_, p);
  const double y = Dot(v, up_);
  return {Dot(v, along_), std::fabs(y) <= kTiny * LengthOf(v) ? 0 : y};
}

void PlaneSight::AddSource(const SourceTriangle& source,
                           const Vec3<double>& normal, const Point3& origin) {
  std::array<double, 3> heights{};
  double far = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<double> v = VectorOf(origin, source[k]);
    heights[k] = Dot(v, normal);
    far = std::max(far, LengthOf(v));
  }
  for (double& height : heights) {
    if (std::fabs(height) <= kTiny * far) height = 0;
  }
  std::vector<Place> places;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (heights[k] == 0) places.push_back(PlaceOf(source[k]));
    if ((heights[k] < 0 && heights[next] > 0) ||
        (heights[k] > 0 && heights[next] < 0)) {
      places.push_back(PlaceOf(Between(
          source[k], source[next], heights[k] / (heights[k] - heights[next]))));
    }
  }
  Source cut;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      if (places[i].y > 0 || places[j].y > 0)
        cut.segments.push_back({places[i], places[j]});
    }
  }
  if (cut.segments.empty()) return;
  cut.front = UnitOf(
      Cross(VectorOf(source[0], source[1]), VectorOf(source[0], source[2])));
  cut.corner = source[0];
  cut.slack = kTiny * far;
  sources_.push_back(std::move(cut));
}

/// Empty, least > most, if no point of the segment lies above the trace.
PlaneSight::Span PlaneSight::SpanOf(const Segment& segment, double t) {
  Span span{HUGE_VAL, -HUGE_VAL};
  const auto take = [&span](double direction) {
    span.least = std::min(span.least, direction);
    span.most = std::max(span.most, direction);
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const Place& p = segment[k];
    const Place& q = segment[1 - k];
    if (p.y > 0) {
      take((p.x - t) / p.y);
    } else if (q.y > 0) {
      // Where the segment goes through the surface.
      const double x = q.x + (p.x - q.x) * (q.y / (q.y - p.y));
      take(std::copysign(HUGE_VAL, x - t));
    }
  }
  return span;
}

bool PlaneSight::TwoLinesOverlapIn(const Span& light, double t) const {
  struct LineSpan {
    Span span;
    int line;
  };

  std::vector<LineSpan> lines;
  for (const Edge& edge : edges_) {
    Span span = SpanOf(edge.segment, t);
    span.least = std::max(span.least, light.least);
    span.most = std::min(span.most, light.most);
    const double size = std::max(
        1.0, std::min({std::fabs(span.least), std::fabs(span.most), kHuge}));
    if (span.most - span.least > kTiny * size)
      lines.push_back({span, edge.line});
  }
  std::ranges::sort(lines, {}, [](const LineSpan& s) { return s.span.least; });
  // How far the lines so far reach: the farthest one, and the farthest other.
  LineSpan first{{0, -HUGE_VAL}, -1};
  LineSpan second = first;
  for (const LineSpan& next : lines) {
    const LineSpan& other = first.line == next.line ? second : first;
    const double most = std::min(other.span.most, next.span.most);
    const double size =
        std::max(1.0, std::min(std::fabs(next.span.least), kHuge));
    if (most - next.span.least > kTiny * size) return true;
    if (next.line == first.line) {
      first.span.most = std::max(first.span.most, next.span.most);
    } else if (next.span.most > first.span.most) {
      second = first;
      first = next;
    } else if (next.span.most > second.span.most) {
      second = next;
    }
  }
  return false;
}

bool PlaneSight::MayHaveKinkAt(const Point3& p) const {
  const double t = Dot(VectorOf(at_, p), along_);
  return std::ranges::any_of(sources_, [&](const Source& source) {
    const Vec3<double> to_p = VectorOf(source.corner, p);
    if (Dot(source.front, to_p) < -source.slack - kTiny * LengthOf(to_p))
      return false;
    Span light{HUGE_VAL, -HUGE_VAL};
    for (const Segment& segment : source.segments) {
      const Span span = SpanOf(segment, t);
      light.least = std::min(light.least, span.least);
      light.most = std::max(light.most, span.most);
    }
    return light.most > light.least && TwoLinesOverlapIn(light, t);
  });
}

}  // namespace truelux
