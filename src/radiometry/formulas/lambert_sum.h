// SPDX-License-Identifier: GPL-3.0-or-later
// Lambert's sum with N = v x v', whatever gives the angles.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_SUM_H_
#define TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_SUM_H_

#include "radiometry/boundary.h"

namespace truelux {

/// The form factor [1] of a region, -(1/2pi) sum angle(v, v', |N|) N_z / |N|:
/// S (3) with errata 2 and 3.
template <class T, class AngleOf>
T LambertSum(const Boundary<T>& region, const AngleOf& angle_of) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    const Vec3<T> normal = Cross(v, w);
    const T length = Length(normal);
    if (IsZero(length)) continue;
    sum = sum - angle_of(v, w, length) * Fraction(normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_SUM_H_
