// SPDX-License-Identifier: GPL-3.0-or-later
// Angles between directions, in binary64: to say how near something is, and to
// leave out what is far away.

#ifndef TRUELUX_VISIBILITY_VIEW_ROUNDED_ANGLES_H_
#define TRUELUX_VISIBILITY_VIEW_ROUNDED_ANGLES_H_

#include <algorithm>
#include <cmath>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// Euclidean length.
inline double RoundedLength(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

/// d at length 1. The largest component is taken out first, so that no
/// intermediate number leaves binary64. (0, 0, 0) stays.
inline Vec3<double> UnitOf(const Vec3<double>& d) {
  const double largest =
      std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (!(largest > 0)) return d;
  const Vec3<double> scaled{d.x / largest, d.y / largest, d.z / largest};
  return 1 / RoundedLength(scaled) * scaled;
}

/// The same of exact numbers and of intervals.
template <class NT>
Vec3<double> UnitOf(const Vec3<NT>& v) {
  return UnitOf(Vec3<double>{CGAL::to_double(v.x), CGAL::to_double(v.y),
                             CGAL::to_double(v.z)});
}

/// The angle between two directions of any length [rad].
inline double AngleBetween(const Vec3<double>& a, const Vec3<double>& b) {
  return std::atan2(RoundedLength(Cross(a, b)), Dot(a, b));
}

/// No more than the angle from d to any direction within `radius` of `center`,
/// both of length 1: an angle is no less than its chord.
inline double LeastAngle(const Vec3<double>& d, const Vec3<double>& center,
                         double radius) {
  return RoundedLength(d - center) - radius;
}

/// The angle from d to the arc between two directions less than pi apart, all
/// of length 1. normal: of the arc's plane, of length 1.
inline double AngleToArc(const Vec3<double>& d, const Vec3<double>& from,
                         const Vec3<double>& to, const Vec3<double>& normal) {
  const bool beside =
      Dot(Cross(normal, from), d) >= 0 && Dot(Cross(to, normal), d) >= 0;
  if (beside) return std::asin(std::min(1.0, std::abs(Dot(normal, d))));
  return std::min(AngleBetween(d, from), AngleBetween(d, to));
}

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_ROUNDED_ANGLES_H_
