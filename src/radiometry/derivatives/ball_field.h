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

/// V and J of one channel, J by rows.
template <class T>
struct BallField {
  BallVector<T> vector;
  std::array<BallVector<T>, 3> jacobian;
};

/// The fields of all channels, by the sums over arcs of docs/derivatives.md (2)
/// and (3) in the form that cancels nothing within an arc (6). What cannot be
/// bounded (an arc of nearly pi, numbers at the ends of the exponent range) has
/// a bound that is infinite or NaN.
///
/// geometry: is evaluated for the contour. Weights as the contour's: M [W/m^2].
template <class T>
std::array<BallField<T>, 3> BallFieldsOf(const WeightedContour& contour,
                                         BallGeometry<T>& geometry);

/// All components of one channel, as field.h has them. m: a normal of the
/// surface that the receiver lies on. scale: of all of them.
template <class T>
ComponentArray<Ball<T>> BallComponentsOf(const BallField<T>& hemisphere,
                                         const BallField<T>& sphere,
                                         const BallVector<T>& n,
                                         const BallVector<T>& m,
                                         const Ball<T>& scale);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_BALL_FIELD_H_
