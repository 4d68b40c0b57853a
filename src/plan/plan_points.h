// SPDX-License-Identifier: GPL-3.0-or-later
// All points that a plan shows.

#ifndef TRUELUX_PLAN_PLAN_POINTS_H_
#define TRUELUX_PLAN_PLAN_POINTS_H_

#include "truelux/isolux.h"

namespace truelux {

/// Calls take(point) for each, ends of the outline first. Where a wall stands
/// at the surface's edge there is a jump instead of an outline, so that the
/// outline alone need not show how large the surface is.
template <class Take>
void ForEachPlanPoint(const Isolux& isolux, const Take& take) {
  for (const auto& side : isolux.outline) {
    for (const Point3& p : side)
      take(p);
  }
  for (const SurfaceLine& line : isolux.lines.lines) {
    for (const Point3& p : line.ends)
      take(p);
  }
  for (const IsoluxContour& contour : isolux.contours) {
    for (const IsoluxVertex& vertex : contour.vertices)
      take(vertex.at);
  }
  for (const OpenTriangle& open : isolux.open) {
    for (const Point3& p : open.corners)
      take(p);
  }
}

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_POINTS_H_
