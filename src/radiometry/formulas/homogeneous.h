// SPDX-License-Identifier: GPL-3.0-or-later
// "homogeneous": the sum over vertices (x, y, 1) and (x, y, 0). S Figure 11.
// Corrections: errata 29 (row 2), 30 (C of the finite point) and 31 (row 4
// without bars, so that the direction of an edge at infinity is unsigned and
// no correction by pi is needed).
//
// Error: that of directions; vertices at infinity add none.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_HOMOGENEOUS_H_
#define TRUELUX_RADIOMETRY_FORMULAS_HOMOGENEOUS_H_

#include "radiometry/formulas/image_vertex.h"

namespace truelux {

/// Row 3: the vertex at infinity (a, b) of an edge through the finite (x, y).
template <class T>
T TowardsInfinity(const ImageVertex<T>& at_infinity,
                  const ImageVertex<T>& finite, const T& pi) {
  const T k = at_infinity.x * finite.y - at_infinity.y * finite.x;
  const Vec3<T> line = {at_infinity.x, at_infinity.y, k};
  return pi * Fraction(k, Length(line)) / Make<T>(2);
}

/// Row 4 for both ends of an edge at infinity with the difference (a, b).
/// clockwise: in the image plane; the sign of ay - bx, which must not be left
/// to rounding: where r is next to the edge, the sum would be off by 2 pi.
template <class T>
T AlongInfinity(const ImageVertex<T>& p, const ImageVertex<T>& q,
                bool clockwise) {
  const T a = q.x - p.x;
  const T b = q.y - p.y;
  // The same for both ends, as (a, b) is their difference.
  const T across = a * q.y - b * q.x;
  const T distance = NonNegative(clockwise ? across : -across);
  const T at_q = a * q.x + b * q.y;
  const T at_p = a * p.x + b * p.y;
  const T beta = Angle(at_q, distance) - Angle(at_p, distance);
  return clockwise ? beta : -beta;
}

/// The form factor [1] of a region.
template <class T>
T Homogeneous(const Boundary<T>& region) {
  const T& pi = region.pi;
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const ImageVertex<T> p = ImageOf(region.From(arc));
    const ImageVertex<T> q = ImageOf(region.To(arc));
    if (p.at_infinity && q.at_infinity) {
      sum = sum + AlongInfinity(p, q, IsNegative(arc.normal.z));
    } else if (q.at_infinity) {
      sum = sum + TowardsInfinity(q, p, pi) - DirectionTerm(p.x, p.y, q.x, q.y);
    } else if (p.at_infinity) {
      sum = sum + DirectionTerm(q.x, q.y, p.x, p.y) - TowardsInfinity(p, q, pi);
    } else {
      sum = PlusFiniteEdge(sum, p, q);
    }
  }
  return sum / (Make<T>(2) * pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_HOMOGENEOUS_H_
