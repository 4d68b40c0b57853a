// SPDX-License-Identifier: GPL-3.0-or-later
// "projective": the sum over the vertices on the projective plane, with points
// at infinity for vertices on the horizon. S Figure 10. Corrections: errata 24
// (the finite point must be finite), 25 (row 3 with the direction of travel is
// +pi/2 at both ends), 26, 27 (+pi or -pi, by the sense, for an edge that
// passes either end of the x axis), 29 and 30 (C of the finite point).
//
// Error: that of directions; vertices at infinity add none.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_PROJECTIVE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_PROJECTIVE_H_

#include "radiometry/formulas/image_vertex.h"

namespace truelux {

/// What a vertex at infinity adds for the edge between it and the finite point
/// (x, y), which runs in the direction (a, b).
template <class T>
T TermAtInfinity(const T& x, const T& y, const T& a, const T& b, const T& pi) {
  const T k = a * y - b * x;
  return pi * Fraction(k, Length(Vec3<T>{a, b, k})) / Make<T>(2);
}

/// Whether (x, y) is on the lower half-turn, [pi, 2 pi), of the line at
/// infinity; its signs must be certain.
template <class T>
bool IsLower(const ImageVertex<T>& p) {
  return IsNegative(p.y) || (IsZero(p.y) && IsNegative(p.x));
}

/// atan(x / y), where x / 0 is infinite.
template <class T>
T AngleAtInfinity(const ImageVertex<T>& p, const T& pi) {
  if (IsZero(p.y)) return pi / Make<T>(2);
  if (IsNegative(p.y)) return Angle(-p.x, -p.y);
  return Angle(p.x, p.y);
}

/// The edge at infinity from p to q.
template <class T>
T EdgeAtInfinity(const ImageVertex<T>& p, const ImageVertex<T>& q,
                 bool clockwise, const T& pi) {
  if constexpr (kIsBall<T>) {
    if (!HasSign(p.y) || !HasSign(q.y)) return Unbounded<double>();
  }
  const T difference = AngleAtInfinity(q, pi) - AngleAtInfinity(p, pi);
  if (IsLower(p) == IsLower(q)) return difference;
  return clockwise ? difference + pi : difference - pi;
}

/// The form factor [1] of a region.
template <class T>
T Projective(const Boundary<T>& region) {
  const T& pi = region.pi;
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const ImageVertex<T> p = ImageOf(region.From(arc));
    const ImageVertex<T> q = ImageOf(region.To(arc));
    if (p.at_infinity && q.at_infinity) {
      sum = sum + EdgeAtInfinity(p, q, IsNegative(arc.normal.z), pi);
    } else if (q.at_infinity) {
      sum = sum + TermAtInfinity(p.x, p.y, q.x, q.y, pi) -
            DirectionTerm(p.x, p.y, q.x, q.y);
    } else if (p.at_infinity) {
      sum = sum + DirectionTerm(q.x, q.y, -p.x, -p.y) +
            TermAtInfinity(q.x, q.y, -p.x, -p.y, pi);
    } else {
      sum = PlusFiniteEdge(sum, p, q);
    }
  }
  return sum / (Make<T>(2) * pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_PROJECTIVE_H_
