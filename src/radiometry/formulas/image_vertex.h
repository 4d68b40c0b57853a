// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the image plane, the plane at unit distance above the receiver.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_IMAGE_VERTEX_H_
#define TRUELUX_RADIOMETRY_FORMULAS_IMAGE_VERTEX_H_

#include "radiometry/boundary.h"

namespace truelux {

/// The point where a ray meets the image plane; of a ray in the receiver plane
/// its direction: a point at infinity.
template <class T>
struct ImageVertex {
  T x;
  T y;
  bool at_infinity = false;
};

template <class T>
ImageVertex<T> ImageOf(const BoundaryVertex<T>& vertex) {
  const Vec3<T>& p = vertex.point;
  if (vertex.on_horizon) return {p.x, p.y, true};
  return {p.x / p.z, p.y / p.z, false};
}

/// F~ of S (45) with erratum 20 (its factors were exchanged):
///   C (a y - b x) atan[C (a x + b y)],  C = 1 / sqrt(a^2 + b^2 + (ay - bx)^2)
/// for the line through (x, y) in the direction (a, b), whose sign is free.
template <class T>
T DirectionTerm(const T& x, const T& y, const T& a, const T& b) {
  const T k = a * y - b * x;
  const T length = Length(Vec3<T>{a, b, k});
  if (IsZero(length)) return length;
  return Fraction(k, length) * Angle(a * x + b * y, length);
}

/// `sum` with what the edge between two finite points adds.
template <class T>
T PlusFiniteEdge(const T& sum, const ImageVertex<T>& p,
                 const ImageVertex<T>& q) {
  const T a = q.x - p.x;
  const T b = q.y - p.y;
  return sum + DirectionTerm(q.x, q.y, a, b) - DirectionTerm(p.x, p.y, a, b);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_IMAGE_VERTEX_H_
