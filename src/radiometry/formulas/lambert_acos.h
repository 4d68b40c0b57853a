// "lambert-acos": Lambert's sum with the angle of an edge as an arccosine, as
// most shaders have it. S (2), (3); H (1). Corrections: errata 2 (the angle is
// to the inward normal), 3 (the constant is M / 2 pi), 8; H (1) is for the
// opposite order of vertices.
//
//   F = -(1/2pi) sum acos(u.u') N_z / |N|,   N = v x v', u = v / |v|
//
// Error: about u / angle for each angle, u / size^3 in all. Unusable below an
// angular size of 1e-3.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ACOS_H_
#define TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ACOS_H_

#include "radiometry/boundary.h"

namespace truelux {

/// The form factor [1] of a region.
template <class T>
T LambertAcos(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    const Vec3<T> normal = Cross(v, w);
    const T length = Length(normal);
    if (IsZero(length)) continue;
    const T beta = ArcCosine(Dot(Unit(v), Unit(w)));
    sum = sum - beta * Fraction(normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ACOS_H_
