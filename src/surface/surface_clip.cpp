// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_clip.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "scene/scene_access.h"

namespace truelux {
namespace {

using Coordinates = SurfaceFrame::Coordinates;

/// Part of a segment, 0 at its start and 1 at its end.
using Span = std::pair<mpq_class, mpq_class>;

/// Keeps where start + share (end - start) >= 0; false if nothing is left.
bool Keep(const mpq_class& start, const mpq_class& end, Span& span) {
  if (start < 0 && end < 0) return false;
  if (start >= 0 && end >= 0) return true;
  const mpq_class share = start / (start - end);
  if (start < 0) {
    if (span.first < share) span.first = share;
  } else if (share < span.second) {
    span.second = share;
  }
  return span.first < span.second;
}

/// Twice the area of three points, positive if counter-clockwise.
mpq_class AreaOf(const Coordinates& p, const Coordinates& q,
                 const Coordinates& r) {
  return (q.a - p.a) * (r.b - p.b) - (q.b - p.b) * (r.a - p.a);
}

std::optional<Span> SpanIn(const std::array<Coordinates, 3>& triangle,
                           const Coordinates& from, const Coordinates& to) {
  Span span{0, 1};
  const int sense = sgn(AreaOf(triangle[0], triangle[1], triangle[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    const Coordinates& p = triangle[k];
    const Coordinates& q = triangle[(k + 1) % 3];
    if (!Keep(sense * AreaOf(p, q, from), sense * AreaOf(p, q, to), span))
      return std::nullopt;
  }
  if (span.first >= span.second) return std::nullopt;
  return span;
}

}  // namespace

SurfaceClip::SurfaceClip(const Scene& scene, const SurfaceFrame& frame,
                         std::span<const int> faces)
    : frame_(frame) {
  for (const int face : faces) {
    const Face& f = scene.faces()[static_cast<std::size_t>(face)];
    for (const Facet& facet :
         scene.facets().subspan(static_cast<std::size_t>(f.first_facet),
                                static_cast<std::size_t>(f.facet_count))) {
      for (const Triangle& triangle : TrianglesOf(scene, facet)) {
        auto& corners = triangles_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          corners[k] = frame.Of(
              scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
        }
      }
    }
  }
}

RationalVector SurfaceClip::PointAt(const Coordinates& at) const {
  return frame_.origin + at.a * frame_.u + at.b * frame_.v;
}

std::vector<ExactSegment> SurfaceClip::PartsOf(
    const ExactSegment& segment) const {
  const Coordinates from = frame_.Of(segment.from);
  const Coordinates to = frame_.Of(segment.to);
  std::vector<Span> spans;
  for (const auto& triangle : triangles_) {
    if (auto span = SpanIn(triangle, from, to)) spans.push_back(*span);
  }
  std::ranges::sort(spans);
  std::vector<ExactSegment> parts;
  const auto add = [&](const Span& span) {
    const RationalVector way = segment.to - segment.from;
    parts.push_back(
        {segment.from + span.first * way, segment.from + span.second * way});
  };
  std::optional<Span> open;
  for (const Span& span : spans) {
    if (open && span.first <= open->second) {
      open->second = std::max(open->second, span.second);
      continue;
    }
    if (open) add(*open);
    open = span;
  }
  if (open) add(*open);
  return parts;
}

std::vector<ExactSegment> SurfaceClip::TraceOf(const RationalVector& normal,
                                               const mpq_class& offset) const {
  // The height over the plane is start + a along_a + b along_b.
  const mpq_class start = Dot(normal, frame_.origin) - offset;
  const mpq_class along_a = Dot(normal, frame_.u);
  const mpq_class along_b = Dot(normal, frame_.v);
  if (along_a == 0 && along_b == 0) return {};
  const std::array<mpq_class, 2> as = {frame_.a_least, frame_.a_most};
  const std::array<mpq_class, 2> bs = {frame_.b_least, frame_.b_most};
  std::vector<Coordinates> ends;
  const auto add = [&](const mpq_class& a, const mpq_class& b) {
    for (const Coordinates& end : ends) {
      if (end.a == a && end.b == b) return;
    }
    ends.push_back({a, b});
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if (along_b != 0) {
      const mpq_class b = -(start + along_a * as[k]) / along_b;
      if (b >= bs[0] && b <= bs[1]) add(as[k], b);
    }
    if (along_a != 0) {
      const mpq_class a = -(start + along_b * bs[k]) / along_a;
      if (a >= as[0] && a <= as[1]) add(a, bs[k]);
    }
  }
  if (ends.size() < 2) return {};
  return {{PointAt(ends[0]), PointAt(ends[1])}};
}

}  // namespace truelux
