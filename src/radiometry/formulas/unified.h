// SPDX-License-Identifier: GPL-3.0-or-later
// "unified": one term for all vertices, finite or not: docs/method.md (11),
//
//   F = (1/2pi) sum H(v, N_in) - H(v, N_out),
//   H(v, N) = (N_z / |N|) atan2(v.(z x N), |N| v_z),   N = v x e
//
// and (12) for edges in the receiver plane. It replaces all other rows of S
// Figures 10 and 11. Error: u / size^2, but none from a vertex near the
// horizon.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_UNIFIED_H_
#define TRUELUX_RADIOMETRY_FORMULAS_UNIFIED_H_

#include "radiometry/formulas/homogeneous.h"

namespace truelux {

/// H at the vertex v of the plane of `normal`, whose length is `length`.
template <class T>
T UnifiedTerm(const Vec3<T>& v, const Vec3<T>& normal, const T& length) {
  return Fraction(normal.z, length) *
         Angle(v.y * normal.x - v.x * normal.y, length * v.z);
}

/// The form factor [1] of a region.
template <class T>
T Unified(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    if (arc.on_horizon) {
      sum = sum + AlongInfinity(ImageOf(region.From(arc)),
                                ImageOf(region.To(arc)),
                                IsNegative(arc.normal.z));
      continue;
    }
    const T length = Length(arc.normal);
    if (IsZero(length)) continue;
    sum = sum + UnifiedTerm(w, arc.normal, length) -
          UnifiedTerm(v, arc.normal, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_UNIFIED_H_
