// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong it is to interpolate in a mesh.

#ifndef TRUELUX_ISOMESH_MESH_ERROR_H_
#define TRUELUX_ISOMESH_MESH_ERROR_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/isomesh.h"

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"
#include "isomesh/light_mesh.h"
#include "isomesh/refined_plane.h"
#include "run/watch.h"

namespace truelux {

/// A point with its true E.
struct LitPoint {
  PlanPoint at;
  double value = 0;
};

/// Points spread evenly over the area, always the same ones, with E. mesh: covers
/// the surface. Throws Stopped.
std::vector<LitPoint> SampleOf(const LightProbe& probe, const PlanMesh& mesh,
                               std::size_t count, int threads,
                               const Watch& watch);

/// The error of linear interpolation at the points of a sample and in the middles
/// of all triangles. plane: whose Mesh() became `mesh`. Throws Stopped.
InterpolationError ErrorOf(const LightProbe& probe, const RefinedPlane& plane,
                           const LightMesh& mesh,
                           std::span<const LitPoint> sample, int threads,
                           const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_MESH_ERROR_H_
