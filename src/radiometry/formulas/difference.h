// SPDX-License-Identifier: GPL-3.0-or-later
// "difference": Lambert's sum with what cancels taken out (docs/method.md (15)
// and (16); not in the papers): with unit vectors u, one of them u_0, and
// d = u - u_0,
//
//   F = -(1/2pi) z.[ sum d x d' + sum (beta - sin beta) N / |N| ]
//
// since sum u x u' = sum d x d' around a closed boundary. Error: u (1 + 1 /
// sin(elevation) + aspect), whatever the size.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_DIFFERENCE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_DIFFERENCE_H_

#include <cstddef>
#include <vector>

#include "radiometry/boundary.h"

namespace truelux {

/// beta - sin beta for 0 <= beta <= pi, sine = sin beta: without cancellation.
template <class T>
T AngleMinusSine(const T& beta, const T& sine) {
  // Written so that a NaN is not summed for ever.
  if (!(Leading(beta) <= 0.7) || IsZero(beta)) return beta - sine;
  const T square = beta * beta;
  T term = beta * square / Make<T>(6);
  T sum = term;
  // An alternating series whose terms fall: what is left out is less than the
  // first term left out.
  for (double k = 4;; k += 2) {
    term = -term * square / Make<T>(k * (k + 1));
    if (IsNegligible(term, sum)) break;
    sum = sum + term;
  }
  return Widened(sum, UpperMagnitude(term));
}

/// The form factor [1] of a region.
template <class T>
T Difference(const Boundary<T>& region) {
  if (region.vertices.empty()) return Make<T>(0);
  const Vec3<T>& first = region.vertices.front().point;
  const T first_length = Length(first);
  const Vec3<T> u = Unit(first);
  IdVector<BoundaryVertexId, Vec3<T>> from_first;
  for (const BoundaryVertex<T>& vertex : region.vertices) {
    const Vec3<T>& v = vertex.point;
    const Vec3<T>& d = vertex.from_first;
    const T length = Length(v);
    const T longer = Dot(d, v - -first) / (length + first_length);
    from_first.push_back({(d.x - u.x * longer) / length,
                          (d.y - u.y * longer) / length,
                          (d.z - u.z * longer) / length});
  }
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const Vec3<T>& v = region.From(arc).point;
    const Vec3<T>& w = region.To(arc).point;
    constexpr BoundaryVertexId kFirst(0);
    if (arc.from != kFirst && arc.to != kFirst) {
      const Vec3<T>& a = from_first[arc.from];
      const Vec3<T>& b = from_first[arc.to];
      sum = sum - (a.x * b.y - a.y * b.x);
    }
    const Vec3<T> normal = Cross(v, arc.chord);
    const T length = Length(normal);
    if (IsZero(length)) continue;
    const T beta = Angle(length, Dot(v, w));
    const T sine = Fraction(length, Length(v) * Length(w));
    sum = sum - AngleMinusSine(beta, sine) * Fraction(normal.z, length);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_DIFFERENCE_H_
