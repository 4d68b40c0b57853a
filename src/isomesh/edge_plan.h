// SPDX-License-Identifier: GPL-3.0-or-later
// The edges that a mesh of a surface must have: lines and contours.

#ifndef TRUELUX_ISOMESH_EDGE_PLAN_H_
#define TRUELUX_ISOMESH_EDGE_PLAN_H_

#include <span>
#include <vector>

#include "isolux/contour_lines.h"
#include "isolux/first_mesh.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A straight edge between two points.
struct PlanEdge {
  int from = 0;  ///< indices into EdgePlan::points
  int to = 0;
  SideKind kind = SideKind::kInner;  ///< kInner: of a contour only
  int seam = -1;                     ///< which of the seams, if of one
  int level = -1;  ///< of which level the contour is; -1: of none
};

/// Edges that meet in their ends only.
struct EdgePlan {
  std::vector<PlanPoint> points;
  std::vector<PlanEdge> edges;
  /// How many ends of contours were drawn to a corner of seams, and how far.
  int drawn = 0;
  double most_drawn = 0;  ///< [length]
  /// Points where edges cross that were not known before: contours that pass a
  /// corner within rounding.
  int crossings = 0;
};

/// Lengths on the plan.
struct EdgeTolerances {
  /// Vertices of contours are left out that are no farther from the chord.
  double chord = 0;
  /// Contours end in corners of seams that are nearer than this: all levels run
  /// into the foot of a vertical edge.
  double corner = 0;
};

/// The edges of seams and contours, each contour divided where it meets a seam.
/// seams: of the first mesh. contours: of the search over that mesh. Vertices are
/// left out by CGAL's simplification of polylines, which keeps the topology.
EdgePlan EdgePlanOf(std::span<const Seam> seams,
                    std::span<const ContourLine> contours,
                    const EdgeTolerances& tolerances);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_EDGE_PLAN_H_
