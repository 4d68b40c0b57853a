// SPDX-License-Identifier: GPL-3.0-or-later
// The straight lines on a flat surface at which irradiance or its gradient
// jumps.

#ifndef TRUELUX_SURFACE_SURFACE_LINES_H_
#define TRUELUX_SURFACE_SURFACE_LINES_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

#include "exact/rational.h"
#include "surface/edge_planes.h"
#include "surface/surface_frame.h"

namespace truelux {

/// A piece of such a line, on the surface. All its points are alike.
struct ExactSurfaceLine {
  RationalVector from;
  RationalVector to;
  /// Whether a face stands on the surface there, so that E may jump; else the
  /// gradient jumps.
  bool is_jump = false;
  Rgb size{};              ///< of a kink: b in the middle [W/m^3]
  std::vector<int> faces;  ///< numbers: that stand there, or are seen edge-on
  /// Of a kink: the edges that cover each other, by indices into
  /// Scene::vertices(); an index of -1: where two faces pierce each other.
  std::vector<std::array<int, 2>> edges;
};

/// The lines of one side of a surface.
struct ExactSurfaceLines {
  std::vector<ExactSurfaceLine> lines;
  /// Whether all planes were looked at (EdgePlanes::is_complete).
  bool is_complete = true;
};

/// The segments where faces touch or cross the surface, and reach above it on
/// the side that is lit. A face that touches it in points only makes none.
/// faces: FacesOfSide.
std::vector<ExactSurfaceLine> JumpLinesOf(const Scene& scene,
                                          const SurfaceFrame& frame,
                                          std::span<const int> faces,
                                          bool is_reverse,
                                          const StopFlag* stop);

/// The faces of a surface that look to one side.
std::vector<int> FacesOfSide(const SurfaceFrame& frame, bool is_reverse);

/// The sides of their triangles that only one of some faces has, by indices into
/// Scene::vertices(): the outline, if no two of them overlap or meet in parts of
/// sides.
std::vector<std::array<int, 2>> OutlineOf(const Scene& scene,
                                          std::span<const int> faces);

/// All lines of a side. planes: EdgePlanesOf the surface.
ExactSurfaceLines SurfaceLinesOf(const Scene& scene, const SurfaceFrame& frame,
                                 const EdgePlanes& planes, bool is_reverse,
                                 const StopFlag* stop);

/// The corners of the surface's first triangle, for EdgePlanesOf.
std::array<Point3, 3> CornersOfSurface(const Scene& scene,
                                       const SurfaceFrame& frame);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_SURFACE_LINES_H_
