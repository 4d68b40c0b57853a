// SPDX-License-Identifier: GPL-3.0-or-later
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

#include "radiometry/formulas/lambert_sum.h"

namespace truelux {

/// The form factor [1] of a region.
template <class T>
T LambertAcos(const Boundary<T>& region) {
  return LambertSum(
      region, [](const Vec3<T>& v, const Vec3<T>& w, const T& /*length*/) {
        return ArcCosine(Dot(Unit(v), Unit(w)));
      });
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ACOS_H_
