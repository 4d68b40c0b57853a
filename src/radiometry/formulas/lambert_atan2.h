// SPDX-License-Identifier: GPL-3.0-or-later
// "lambert-atan2": Lambert's sum with the angle from its sine and cosine. S
// (2), (3); H (1), with the same corrections as lambert-acos.
//
//   F = -(1/2pi) sum atan2(|N|, v.v') N_z / |N|,   N = v x v'
//
// Error: N loses what v and v' have in common, u / size^2.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_
#define TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_

#include "radiometry/formulas/lambert_sum.h"

namespace truelux {

/// The form factor [1] of a region.
template <class T>
T LambertAtan2(const Boundary<T>& region) {
  return LambertSum(region,
                    [](const Vec3<T>& v, const Vec3<T>& w, const T& length) {
                      return Angle(length, Dot(v, w));
                    });
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_ATAN2_H_
