// SPDX-License-Identifier: GPL-3.0-or-later
// Points placed by where a receiver sees them.

#ifndef TRUELUX_BASELINES_CASE_CHART_H_
#define TRUELUX_BASELINES_CASE_CHART_H_

#include <cmath>

#include "truelux/geometry.h"

namespace truelux {

/// A point of the chart [1; near the axis: rad].
struct ChartPoint {
  double x = 0;
  double y = 0;
};

/// The plane at distance 1 in front of a viewer at the origin, with
/// right-handed axes (right, up, axis): clockwise in (x, y) is
/// counter-clockwise seen from the origin.
struct CaseChart {
  Vector3 axis;
  Vector3 right;
  Vector3 up;

  /// The axis at that azimuth and elevation [rad] above z = 0; right is
  /// horizontal.
  static CaseChart Looking(double azimuth, double elevation) {
    const double ca = std::cos(azimuth);
    const double sa = std::sin(azimuth);
    const double ce = std::cos(elevation);
    const double se = std::sin(elevation);
    return {{ca * ce, sa * ce, se}, {-sa, ca, 0}, {-ca * se, -sa * se, ce}};
  }

  /// `distance` times the point of the chart.
  [[nodiscard]] Point3 At(const ChartPoint& q, double distance) const {
    return {distance * (axis.x + q.x * right.x + q.y * up.x),
            distance * (axis.y + q.x * right.y + q.y * up.y),
            distance * (axis.z + q.x * right.z + q.y * up.z)};
  }
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_CASE_CHART_H_
