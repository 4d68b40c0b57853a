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

/// a u + b v.
template <class T>
BallVector<T> Combined(const Ball<T>& a, const BallVector<T>& u,
                       const Ball<T>& b, const BallVector<T>& v) {
  BallVector<T> sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum.value[k] = SumOfProducts(a.value, u.value[k], b.value, v.value[k]);
  sum.length = LengthOf(sum.value);
  const double a_size = Magnitude(a.value);
  const double b_size = Magnitude(b.value);
  sum.error = RoundBoundUp(a.error * (u.length + u.error) + a_size * u.error +
                           b.error * (v.length + v.error) + b_size * v.error +
                           RoundingError<T>::kDot2 *
                               (a_size * u.length + b_size * v.length));
  return sum;
}

/// A sum of vectors with factors. Costs less than Sum and Times: the length of
/// the sum is found at the end.
template <class T>
class VectorSum {
 public:
  /// Adds s v. Its product is off by kProduct of |s v|, the sum by kSum of its
  /// length, which is at most the sum of its components' sizes.
  void Add(const Ball<T>& s, const BallVector<T>& v) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      value_[k] = value_[k] + s.value * v.value[k];
      size += Magnitude(value_[k]);
    }
    const double s_size = Magnitude(s.value);
    error_ = RoundBoundUp(error_ + s.error * (v.length + v.error) +
                          s_size * v.error +
                          RoundingError<T>::kProduct * (s_size * v.length) +
                          RoundingError<T>::kSum * size);
  }

  /// Subtracts s v.
  void Subtract(const Ball<T>& s, const BallVector<T>& v) { Add(-s, v); }

  [[nodiscard]] BallVector<T> Get() const {
    return {value_, LengthOf(value_), error_};
  }

 private:
  Components<T> value_{};
  double error_ = 0;
};

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

  /// n, scaled by a power of two.
  [[nodiscard]] const BallVector<T>& ReceiverNormal() const {
    return geometry_.receiver_normal();
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
  IdVector<DirectionId, Ball<T>> lengths_;
  IdVector<DirectionId, BallVector<T>> units_;
  IdVector<PlaneId, BallVector<T>> normals_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_BALL_ARCS_H_
