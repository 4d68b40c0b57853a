// SPDX-License-Identifier: GPL-3.0-or-later
// Areas of the regions of a whole view, by textbook formulas in double.

#ifndef TRUELUX_TESTS_SUPPORT_VIEW_SUMS_H_
#define TRUELUX_TESTS_SUPPORT_VIEW_SUMS_H_

#include <cmath>
#include <numbers>

#include "visibility/view/whole_view.h"

namespace truelux::testing {

inline double DotOf(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector3 CrossOf(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double LengthOf(const Vector3& a) {
  return std::sqrt(DotOf(a, a));
}

inline Vector3 Negated(const Vector3& a) {
  return {-a.x, -a.y, -a.z};
}

inline const Vector3& DirectionOf(const WholeView& view, int vertex) {
  return view.vertices[static_cast<std::size_t>(vertex)].vertex.direction;
}

/// The angle of an arc [rad], in (0, 2 pi].
inline double AngleOf(const WholeView& view, const WholeViewArc& arc) {
  if (arc.from == arc.to) return 2 * std::numbers::pi;
  const Vector3& a = DirectionOf(view, arc.from);
  const Vector3& b = DirectionOf(view, arc.to);
  const double angle = std::atan2(
      DotOf(CrossOf(a, b), arc.plane_normal) / LengthOf(arc.plane_normal),
      DotOf(a, b));
  // Rounding must not turn a short arc into a circle, nor the reverse.
  if (!arc.at_least_pi) return std::abs(angle);
  return angle < 1 ? angle + 2 * std::numbers::pi : angle;
}

/// Lambert: the area of a region in the disc of radius 1, divided by pi.
inline double DiscShareOf(const WholeView& view, std::size_t region,
                          const Vector3& normal) {
  double sum = 0;
  for (const WholeViewArc& arc : view.arcs) {
    const double sign = arc.left == static_cast<int>(region)    ? 1
                        : arc.right == static_cast<int>(region) ? -1
                                                                : 0;
    sum += sign * AngleOf(view, arc) * DotOf(arc.plane_normal, normal) /
           LengthOf(arc.plane_normal);
  }
  return sum / (2 * std::numbers::pi * LengthOf(normal));
}

/// Gauss and Bonnet: 2 pi times (2 - number of loops) minus the turns at the
/// vertices.
inline double SolidAngleByTurns(const WholeView& view, std::size_t region) {
  const ViewRegion& r = view.regions[region];
  double sum = 2 * std::numbers::pi * (2 - static_cast<double>(r.loops.size()));
  for (const ViewLoop& loop : r.loops) {
    for (std::size_t i = 0; i < loop.arcs.size(); ++i) {
      const WholeViewArc& in =
          view.arcs[static_cast<std::size_t>(loop.arcs[i])];
      const WholeViewArc& out = view.arcs[static_cast<std::size_t>(
          loop.arcs[(i + 1) % loop.arcs.size()])];
      const bool in_left = in.left == static_cast<int>(region);
      const bool out_left = out.left == static_cast<int>(region);
      const int vertex = in_left ? in.to : in.from;
      if (vertex < 0) continue;
      const Vector3& d = DirectionOf(view, vertex);
      const Vector3 n = in_left ? in.plane_normal : Negated(in.plane_normal);
      const Vector3 m = out_left ? out.plane_normal : Negated(out.plane_normal);
      // Tangents turn as the normals do.
      sum -= std::atan2(DotOf(CrossOf(n, m), d) / LengthOf(d), DotOf(n, m));
    }
  }
  return sum;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_VIEW_SUMS_H_
