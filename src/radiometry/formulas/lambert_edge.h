// "lambert-edge": Lambert's sum with N = v x e, e = v' - v: the difference
// first, so that a short edge keeps all bits. S (2), (3), with the same
// corrections as lambert-acos.
//
//   F = -(1/2pi) sum atan2(|v x e|, v.v') N_z / |N|
//
// N is v x e for whole edges; part of an edge takes the edge's plane. Error:
// every term is relatively accurate and of the order of the size, their sum of
// its square: u / (size cos theta). The one to use in double.

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
    const T sine = Length(Cross(v, arc.chord));
    const T length = Length(arc.normal);
    if (IsZero(length)) continue;
    sum = sum - Angle(sine, Dot(v, region.To(arc).point)) *
                    Fraction(arc.normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_LAMBERT_EDGE_H_
