// SPDX-License-Identifier: GPL-3.0-or-later
// What lies in one plane through a trace on a flat surface, exactly and in two
// dimensions.

#ifndef TRUELUX_SURFACE_PLANE_CUT_H_
#define TRUELUX_SURFACE_PLANE_CUT_H_

#include <array>
#include <cstddef>
#include <vector>

#include <gmpxx.h>

#include "truelux/scene.h"

#include "exact/rational.h"
#include "surface/edge_planes.h"
#include "surface/surface_frame.h"

namespace truelux {

/// The coordinates of a plane P that meets the surface in a trace: the point
/// (x, y) is from + x along + y up. y is 0 on the trace and positive on the
/// lit side of the surface. The axes are at right angles, but not of length 1.
struct CutAxes {
  RationalVector normal;   ///< of P, of any length
  RationalVector surface;  ///< normal of the surface, to the lit side
  RationalVector from;     ///< (0, 0)
  RationalVector along;    ///< (1, 0) lies at from + along
  RationalVector up;

  /// The point (x, 0) of the trace.
  [[nodiscard]] RationalVector PointAt(const mpq_class& x) const;
};

/// A line of P: x + b y = c, or y = c if it is level.
struct CutLine {
  bool is_level = false;
  mpq_class b;  ///< 1 if it is level
  mpq_class c;

  friend bool operator==(const CutLine&, const CutLine&) = default;

  /// The line's height over the receiver (t, 0), times something that has one
  /// sign on each side of the line. 0: the line goes through the receiver.
  [[nodiscard]] mpq_class HeightAt(const mpq_class& t) const {
    return is_level ? c : mpq_class(c - t);
  }
};

/// A point (x, y) of P above the trace, as x / y and 1 / y. From (t, 0) it is
/// seen along (u, 1) with u = p - t z, at the height y = 1 / z. A line is
/// straight in (u, z), too.
struct CutPoint {
  mpq_class p;
  mpq_class z;
  std::vector<int> lines;  ///< some of the lines through it

  [[nodiscard]] mpq_class DirectionFrom(const mpq_class& t) const {
    return p - t * z;
  }
};

/// An end of a segment that is no CutPoint: it lies on the trace, where the
/// segment's line meets it.
inline constexpr int kOnTrace = -1;

/// A part of a line: ends are indices into PlaneCut::points, or kOnTrace.
struct CutSegment {
  int line = 0;
  std::array<int, 2> ends{};
};

/// A part of a facet that P crosses, or that has an edge in P.
struct CutFacet {
  int facet = 0;  ///< index into Scene::facets()
  CutSegment segment;
  int side = 0;    ///< where it lies beside P: 1 along the normal, -1, 0: both
  int turn = 1;    ///< the front is seen where turn * HeightAt(t) < 0
  mpq_class tilt;  ///< of facets with one line: how far they lean along the
                   ///< normal, times their HeightAt(t)
  bool is_light = false;  ///< emits, and may show its front
  bool is_bound = false;  ///< what is seen may change at its line
};

/// A triangle in P, by its sides above the trace.
struct CutFlat {
  int facet = 0;       ///< index into Scene::facets()
  int front_side = 1;  ///< to which side of P its front looks
  std::vector<CutSegment> sides;
  bool is_light = false;  ///< emits
};

/// An edge of the scene that lies in P.
struct CutEdge {
  std::array<int, 2> ends{};  ///< indices into Scene::vertices()
  CutSegment segment;
};

/// All that lies in P above the trace. What lies in the plane of the surface is
/// left out.
struct PlaneCut {
  CutAxes axes;
  std::vector<CutLine> lines;    ///< each once
  std::vector<CutPoint> points;  ///< each once: ends, and crossings if added
  std::vector<CutFacet> facets;
  std::vector<CutFlat> flats;
  std::vector<CutEdge> edges;
  /// Intervals of x in which a face above the surface meets the trace along it:
  /// receivers there lie on that face.
  std::vector<std::array<mpq_class, 2>> contacts;
};

/// The axes of a plane of which from and to are two points on the surface.
/// reversed_side: whether the lit side is the back of the frame's first face.
/// Throws std::invalid_argument if from and to are equal or not in both planes,
/// or if the plane is the surface's.
[[nodiscard]] CutAxes CutAxesOf(const Scene& scene, const SurfaceFrame& frame,
                                const EdgePlane& plane,
                                const RationalVector& from,
                                const RationalVector& to, bool reversed_side);

/// What lies in a plane, without crossings, and with every triangle on its own;
/// nothing if no facet that emits meets the plane.
[[nodiscard]] PlaneCut PlaneCutOf(const Scene& scene, const EdgePlanes& planes,
                                  std::size_t plane_index, const CutAxes& axes);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_PLANE_CUT_H_
