// SPDX-License-Identifier: GPL-3.0-or-later
// What the arcs of a contour add to derivatives, as balls: the parts that the
// receiver's and the vertices' have in common.
//
// Letters: N the normal of an arc's plane, a and b the ends of the edge that it
// lies on, relative to r; u1 and u2 the unit directions of the arc's ends.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_BALL_ARCS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_BALL_ARCS_H_

#include <cstddef>
#include <limits>

#include "base/id_vector.h"
#include "exact/ball_vector.h"
#include "radiometry/stages/ball_geometry.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// a + b.
template <class T>
BallVector<T> Sum(const BallVector<T>& a, const BallVector<T>& b) {
  BallVector<T> sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum.value[k] = a.value[k] + b.value[k];
  sum.length = LengthOf(sum.value);
  sum.error =
      RoundBoundUp(a.error + b.error + RoundingError<T>::kSum * sum.length);
  return sum;
}

/// s v.
template <class T>
BallVector<T> Times(const Ball<T>& s, const BallVector<T>& v) {
  BallVector<T> product;
  for (std::size_t k = 0; k < 3; ++k)
    product.value[k] = s.value * v.value[k];
  product.length = LengthOf(product.value);
  product.error = RoundBoundUp(s.error * (v.length + v.error) +
                               Magnitude(s.value) * v.error +
                               RoundingError<T>::kProduct * product.length);
  return product;
}

/// v 2^exponent.
template <class T>
BallVector<T> Shifted(const BallVector<T>& v, int exponent) {
  if (exponent < -800 || exponent > 800)
    return {v.value, v.length, std::numeric_limits<double>::infinity()};
  const double factor = PowerOfTwo(exponent);
  BallVector<T> shifted;
  for (std::size_t k = 0; k < 3; ++k)
    shifted.value[k] = TimesPowerOfTwo(v.value[k], factor);
  shifted.length = LengthOf(shifted.value);
  shifted.error = v.error * factor + kUnderflow;
  return shifted;
}

/// One arc. For a vector y in its plane the integral of w (w . y) over it, w the
/// unit directions, is
///
///   W y = A (q1 + q2)(u1 + u2) + B (q2 - q1)(u2 - u1),   q = y . u at the ends,
///   A = (beta + s) / (4 (1 + c)),   B = (beta - s)(1 + c) / (4 s^2),
///
/// s and c the sine and cosine of the arc's angle beta [docs/derivatives.md (6)].
template <class T>
struct BallArc {
  BallVector<T> inward;  ///< unit normal of the plane, into the visible side
  Ball<T> angle;         ///< beta
  Ball<T> a;             ///< A
  Ball<T> b;             ///< B
};

/// The directions, planes and arcs of one contour.
template <class T>
class BallArcs {
 public:
  /// geometry: is evaluated for the contour. Both must outlive the object.
  BallArcs(const WeightedContour& contour, BallGeometry<T>& geometry);

  [[nodiscard]] const WeightedContour& contour() const { return contour_; }

  /// The unit vector of a direction.
  [[nodiscard]] const BallVector<T>& Unit(DirectionId id) const {
    return units_[id];
  }

  /// N / |N|.
  [[nodiscard]] const BallVector<T>& UnitNormal(PlaneId id) const {
    return normals_[id];
  }

  /// N, scaled.
  [[nodiscard]] const ScaledVector<T>& Normal(PlaneId id) const {
    return geometry_.Plane(id).normal;
  }

  /// An arc; without A and B if it is on the horizon, where they are not needed.
  [[nodiscard]] BallArc<T> At(const Arc& arc) const;

 private:
  [[nodiscard]] Ball<T> SineOf(const Arc& arc) const;

  WeightedContour contour_;
  const BallGeometry<T>& geometry_;
  IdVector<DirectionId, BallVector<T>> units_;
  IdVector<PlaneId, BallVector<T>> normals_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_BALL_ARCS_H_
