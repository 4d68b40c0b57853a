// SPDX-License-Identifier: GPL-3.0-or-later
// "vertex-lambert": Lambert's sum in terms of vertices: the angles of each
// vertex with its two edges. S (12), (13). Corrections: errata 7 and 8 (the
// constant is M / 2 pi; the edges have indices and need not be unit vectors),
// and the angle from its sine and cosine instead of an arccosine.
//
//   F = (1/2pi) sum angle(v, e_in) N_in,z / |N_in| - angle(v, e_out) ...,
//   N = v x e
//
// Error: the angles are not small, their differences are: u / size^2.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_VERTEX_LAMBERT_H_
#define TRUELUX_RADIOMETRY_FORMULAS_VERTEX_LAMBERT_H_

#include "radiometry/boundary.h"

namespace truelux {

/// What the end v of an arc adds: the angle of v with the arc's edge, times
/// the cosine of its plane.
template <class T>
T AngleWithEdge(const Vec3<T>& v, const BoundaryArc<T>& arc) {
  const Vec3<T> normal = Cross(v, arc.edge);
  const T length = Length(normal);
  if (IsZero(length)) return length;
  return Angle(length, Dot(v, arc.edge)) * Fraction(normal.z, length);
}

/// The form factor [1] of a region.
template <class T>
T VertexLambert(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    sum = sum + AngleWithEdge(region.To(arc).point, arc) -
          AngleWithEdge(region.From(arc).point, arc);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_VERTEX_LAMBERT_H_
