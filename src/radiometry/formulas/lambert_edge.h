// SPDX-License-Identifier: GPL-3.0-or-later
// "lambert-edge": Lambert's sum with N = v x e, e = v' - v: the difference
// first, so that a short edge keeps all bits. S (2), (3), with the same
// corrections as lambert-acos.
//
//   F = -(1/2pi) sum atan2(|v x e|, v.v') N_z / |N|
//
// The ends that e lies between are those of the arc, rounded or not: the exact
// plane of its edge would not fit to them, and the error would be u / size^2
// where blockers cut the edges of a small source. Error: every term is
// relatively accurate and of the order of the size, their sum of its square:
// u / (size cos theta). The one to use in double.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_EDGE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_EDGE_H_

#include "radiometry/boundary.h"

namespace truelux {

/// The form factor [1] of a region.
template <class T>
T LambertEdge(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    // In the receiver plane the sense of the normal is exact.
    const Vec3<T> normal = arc.on_horizon ? arc.normal : Cross(v, arc.chord);
    const T sine = Length(Cross(v, arc.chord));
    const T length = Length(normal);
    if (IsZero(length)) continue;
    sum = sum - Angle(sine, Dot(v, region.To(arc).point)) *
                    Fraction(normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_EDGE_H_
