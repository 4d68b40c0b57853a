// "lambert-atan2": Lambert's sum with the angle from its sine and cosine. S
// (2), (3); H (1), with the same corrections as lambert-acos.
//
//   F = -(1/2pi) sum atan2(|N|, v.v') N_z / |N|,   N = v x v'
//
// Error: N loses what v and v' have in common, u / size^2.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_
#define TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_

#include "radiometry/boundary.h"

namespace truelux {

/// The form factor [1] of a region.
template <class T>
T LambertAtan2(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    const Vec3<T> normal = Cross(v, w);
    const T length = Length(normal);
    if (IsZero(length)) continue;
    sum = sum - Angle(length, Dot(v, w)) * Fraction(normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_
