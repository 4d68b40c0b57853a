// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of sources in double-double with running bounds: the stage that
// answers nearly always.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_BALL_FIELD_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_BALL_FIELD_H_

#include <array>
#include <cstddef>

#include "exact/ball_vector.h"
#include "radiometry/derivatives/components.h"
#include "radiometry/stages/ball_geometry.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// V and J, J by rows; and n.J, n the scaled normal of the receiver.
template <class T>
struct BallField {
  BallVector<T> vector;
  std::array<BallVector<T>, 3> jacobian;
  BallVector<T> moment;
};

/// Which numbers of fields are wanted; V always is. n.J alone costs less than J.
struct FieldParts {
  bool jacobian = true;  ///< also n.J
  bool moment = true;
};

/// The fields of all channels.
template <class T>
struct BallFields {
  /// Where all sources have the same weights: the field of weight 1, and the
  /// weights. `channels` is then empty.
  BallField<T> common{};
  Rgb weights{};
  bool has_common = true;
  std::array<BallField<T>, 3> channels{};
};

/// The fields of all channels, by the sums over arcs of docs/derivatives.md (2)
/// and (3) in the form that cancels nothing within an arc (6). What cannot be
/// bounded (an arc of nearly pi, numbers at the ends of the exponent range) has
/// a bound that is infinite or NaN.
///
/// geometry: is evaluated for the contour. Weights as the contour's: M [W/m^2].
template <class T>
BallFields<T> BallFieldsOf(const WeightedContour& contour,
                           const FieldParts& parts, BallGeometry<T>& geometry);

/// The components of a field.
template <class T>
struct BallComponents {
  ComponentArray<Ball<T>> components;  ///< as field.h has them
  Ball<T> irradiance;                  ///< n.V / |n|
};

/// All components of one field over the hemisphere and one over the sphere;
/// those of parts that the fields are without are 0. n: the receiver's normal,
/// scaled as the fields'; m: a normal of the surface that the receiver lies on.
template <class T>
BallComponents<T> BallComponentsOf(const BallField<T>& hemisphere,
                                   const BallField<T>& sphere,
                                   const BallVector<T>& n,
                                   const BallVector<T>& m);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_BALL_FIELD_H_
