// SPDX-License-Identifier: GPL-3.0-or-later
// "sphere": the sum over vertices given by their longitude phi and latitude
// alpha on the unit sphere, and by the angle chi of their edges with the
// meridian. S (27), (28) with (17), (18). Corrections: errata 11 (alpha = 0 is
// a limit), 12, 13 (G = -phi for both senses along the equator) and 14 (the
// count c of edges along the equator that pass phi = 0).
//
//   G = cos alpha sin chi atan(cos chi / tan alpha)
//
// The sines and cosines are ratios of coordinates. Error: u / size^2.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_SPHERE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_SPHERE_H_

#include "radiometry/boundary.h"

namespace truelux {

/// G at the vertex v of an edge in the plane of unit normal n.
template <class T>
T MeridianTerm(const Vec3<T>& v, const Vec3<T>& n) {
  const T zero = Make<T>(0);
  const T reach = Length(Vec3<T>{v.x, v.y, zero});
  if (IsZero(reach)) return zero;
  const T length = Length(v);
  const T sin_alpha = v.z / length;
  const T cos_alpha = reach / length;
  const T cos_phi = Fraction(v.x, reach);
  const T sin_phi = Fraction(v.y, reach);
  const T sin_chi =
      n.z * cos_alpha - (n.x * cos_phi + n.y * sin_phi) * sin_alpha;
  const T cos_chi = n.x * sin_phi - n.y * cos_phi;
  return cos_alpha * sin_chi * Angle(cos_chi * cos_alpha, sin_alpha);
}

/// The turns c of an edge along the equator from phi to phi', 0 or +-1.
template <class T>
T EquatorTurns(const T& phi, const T& next, bool westward) {
  const T ahead = next - phi;
  if constexpr (kIsBall<T>) {
    if (!HasSign(ahead)) return Unbounded<double>();
  }
  if (westward) return Make<T>(IsNegative(ahead) || IsZero(ahead) ? 0 : 1);
  return Make<T>(IsNegative(ahead) ? -1 : 0);
}

/// The form factor [1] of a region.
template <class T>
T SphereVertices(const Boundary<T>& region) {
  T sum = Make<T>(0);
  T turns = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    if (arc.on_horizon) {
      const T phi = AngleFromAxis(v.y, v.x);
      const T next = AngleFromAxis(w.y, w.x);
      sum = sum + phi - next;
      turns = turns + EquatorTurns(phi, next, IsNegative(arc.normal.z));
      continue;
    }
    const Vec3<T> normal = Cross(v, w);
    const T length = Length(normal);
    if (IsZero(length)) continue;
    const Vec3<T> unit = {Fraction(normal.x, length),
                          Fraction(normal.y, length),
                          Fraction(normal.z, length)};
    sum = sum + MeridianTerm(w, unit) - MeridianTerm(v, unit);
  }
  return turns + sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_SPHERE_H_
