// SPDX-License-Identifier: GPL-3.0-or-later
// What points on a surface see in one plane through them: lines, and light.

#ifndef TRUELUX_SURFACE_PLANE_SIGHT_H_
#define TRUELUX_SURFACE_PLANE_SIGHT_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/geometry.h"

#include "exact/vec3.h"

namespace truelux {

/// An edge that lies in the plane.
struct PlaneEdge {
  std::array<Point3, 2> ends;
  int line = 0;  ///< the same for edges on one line
};

/// A triangle that emits from its front, the side from which its corners run
/// counter-clockwise.
using SourceTriangle = std::array<Point3, 3>;

/// The lines and the lights of a plane as they lie before points of its trace
/// on a flat surface. In double, as a sieve: it lets through what rounding
/// leaves open, and may lose overlaps of an angle below 1e-9, whose kinks are
/// as small.
class PlaneSight {
 public:
  /// edges: in the plane. normal: of the plane. up: a normal of the surface, on
  /// the side of the light. at: a point of the surface.
  PlaneSight(std::span<const PlaneEdge> edges,
             std::span<const SourceTriangle> sources,
             const Vec3<double>& normal, const Vec3<double>& up,
             const Point3& at);

  /// Whether edges of two lines overlap, as seen from a point of the trace, in
  /// directions in which a source lies that looks to it. Otherwise the
  /// irradiance has no kink there across the plane.
  [[nodiscard]] bool MayHaveKinkAt(const Point3& p) const;

 private:
  /// Coordinates in the plane: x along the trace, y above the surface.
  struct Place {
    double x = 0;
    double y = 0;
  };

  using Segment = std::array<Place, 2>;

  struct Edge {
    Segment segment;
    int line = 0;
  };

  /// The part of a source in the plane: the hull of the segments.
  struct Source {
    std::vector<Segment> segments;
    Vec3<double> front{};
    Point3 corner;
    double slack = 0;  ///< of heights over the source
  };

  /// Directions (x - t) / y, which fall from left to right.
  struct Span {
    double least;
    double most;
  };

  [[nodiscard]] Place PlaceOf(const Point3& p) const;
  void AddSource(const SourceTriangle& source, const Vec3<double>& normal,
                 const Point3& origin);
  static Span SpanOf(const Segment& segment, double t);
  [[nodiscard]] bool TwoLinesOverlapIn(const Span& light, double t) const;

  Vec3<double> up_;
  Vec3<double> along_;  ///< the trace
  Point3 at_;
  std::vector<Edge> edges_;
  std::vector<Source> sources_;
};

}  // namespace truelux

#endif  // TRUELUX_SURFACE_PLANE_SIGHT_H_
