// SPDX-License-Identifier: GPL-3.0-or-later
// A Delaunay mesh over given edges, refined where it is asked for.

#ifndef TRUELUX_ISOMESH_REFINED_PLANE_H_
#define TRUELUX_ISOMESH_REFINED_PLANE_H_

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "truelux/stop.h"

#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"
#include "isomesh/edge_plan.h"

namespace truelux {

/// A triangle by its corners, the least one first, in the order of the mesh.
using Corners = std::array<int, 3>;

/// Triangles with shared points. PlanTriangle::seams are indices into the edges
/// of the plan; neighbours are not there across jumps and outlines.
struct SharedMesh {
  std::vector<PlanPoint> points;
  std::vector<PlanTriangle> triangles;
};

/// A constrained Delaunay triangulation of one side of a surface. CGAL's Delaunay
/// mesher divides triangles and edges; edges are divided in the middle, and
/// wherever a point comes near.
class RefinedPlane {
 public:
  /// plan: outlines and jumps enclose the surface. is_inside: whether a point
  /// away from all edges is on the surface.
  RefinedPlane(const EdgePlan& plan,
               const std::function<bool(const PlanPoint&)>& is_inside);
  ~RefinedPlane();
  RefinedPlane(const RefinedPlane&) = delete;
  RefinedPlane& operator=(const RefinedPlane&) = delete;

  /// Divides triangles until none of these is left, the largest numbers first, but
  /// for those that are as thin as a rounding. Ends at so many points. Throws
  /// Stopped.
  void Divide(const std::map<Corners, double>& triangles,
              std::size_t most_points, const StopFlag* stop);

  /// Divides triangles until no side is longer.
  void DivideTo(double longest, const StopFlag* stop);

  [[nodiscard]] std::size_t point_count() const;

  [[nodiscard]] SharedMesh Mesh() const;

  /// The index in Mesh() of the triangle that holds a point, if one does. Not
  /// from several threads.
  [[nodiscard]] std::optional<int> TriangleAt(const PlanPoint& p) const;

 private:
  class Plane;
  std::unique_ptr<Plane> plane_;
};

/// The corners in the order that RefinedPlane::Divide knows.
Corners OrderedCorners(const Corners& corners);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_REFINED_PLANE_H_
