// SPDX-License-Identifier: GPL-3.0-or-later
// Plans of edges made by hand, and what must hold of edges.

#ifndef TRUELUX_TESTS_ISOMESH_PLAN_CHECKS_H_
#define TRUELUX_TESTS_ISOMESH_PLAN_CHECKS_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "isolux/contour_lines.h"
#include "isolux/first_mesh.h"
#include "isomesh/edge_plan.h"

namespace truelux::testing {

/// The sides of a rectangle.
inline std::vector<Seam> RectangleSeams(PlanPoint least, PlanPoint most,
                                        SideKind kind) {
  const std::array<PlanPoint, 4> corners = {
      {least, {most.s, least.t}, most, {least.s, most.t}}};
  std::vector<Seam> seams;
  for (std::size_t i = 0; i < 4; ++i)
    seams.push_back({corners[i], corners[(i + 1) % 4], kind, -1});
  return seams;
}

/// An arc of a circle in equal steps, closed if it is a whole one.
inline ContourLine ArcLine(std::size_t level, PlanPoint centre, double radius,
                           int steps, double turn = 2 * std::numbers::pi) {
  ContourLine line;
  line.level = level;
  line.is_closed = turn == 2 * std::numbers::pi;
  for (int i = 0; i < steps + (line.is_closed ? 0 : 1); ++i) {
    const double angle = turn * i / steps;
    ContourPoint point;
    point.at = centre + radius * PlanPoint{std::cos(angle), std::sin(angle)};
    line.points.push_back(point);
  }
  return line;
}

inline double LengthOf(const EdgePlan& plan, const PlanEdge& edge) {
  return truelux::LengthOf(plan.points[static_cast<std::size_t>(edge.from)] -
                           plan.points[static_cast<std::size_t>(edge.to)]);
}

/// How many pairs of edges have a point in common that is no end of both.
inline int CrossingsOf(const EdgePlan& plan) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [&](int i) {
    const PlanPoint& p = plan.points[static_cast<std::size_t>(i)];
    return Kernel::Point_2(p.s, p.t);
  };
  int crossings = 0;
  for (std::size_t i = 0; i < plan.edges.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const PlanEdge& one = plan.edges[i];
      const PlanEdge& other = plan.edges[k];
      const bool meet = one.from == other.from || one.from == other.to ||
                        one.to == other.from || one.to == other.to;
      const Kernel::Segment_2 s(at(one.from), at(one.to));
      const Kernel::Segment_2 t(at(other.from), at(other.to));
      if (!meet && CGAL::do_intersect(s, t)) ++crossings;
    }
  }
  return crossings;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_ISOMESH_PLAN_CHECKS_H_
