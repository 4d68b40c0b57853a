// SPDX-License-Identifier: GPL-3.0-or-later
// One side of a surface, ready for a search: most surfaces have one.

#ifndef TRUELUX_ISOLUX_SURFACE_SIDE_H_
#define TRUELUX_ISOLUX_SURFACE_SIDE_H_

#include <array>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "isolux/first_mesh.h"
#include "isolux/plan_frame.h"
#include "run/watch.h"
#include "surface/edge_planes.h"
#include "surface/surface_frame.h"
#include "surface/surface_lines.h"

namespace truelux {

/// The faces that look to one side, with the lines on them.
struct SurfaceSide {
  std::vector<int> faces;  ///< indices into Scene::faces()
  PlanFrame plan;
  ExactSurfaceLines lines;
};

/// The sides of a surface that have faces. frame, planes: of this scene and
/// surface.
std::vector<SurfaceSide> SidesOf(const Scene& scene, const SurfaceFrame& frame,
                                 const EdgePlanes& planes, const Watch& watch);

/// The lines of a side for the user, with E beside jumps. aside: how far
/// [length].
std::vector<SurfaceLine> ShownLines(const Oracle& oracle,
                                    const SurfaceSide& side, double aside);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_SURFACE_SIDE_H_
