// SPDX-License-Identifier: GPL-3.0-or-later
// Planes and directions as balls, scaled so that nothing over- or underflows.

#ifndef TRUELUX_EXACT_BALL_RECIPE_H_
#define TRUELUX_EXACT_BALL_RECIPE_H_

#include "exact/ball.h"
#include "exact/ball_vector.h"
#include "exact/recipe_evaluator.h"

namespace truelux {

/// a - b: its error is known exactly.
template <>
struct DifferenceOf<Ball<double>> {
  static Ball<double> Of(double a, double b) {
    const DoubleDouble difference = TwoSum(a, -b);
    return {difference.high, std::fabs(difference.low)};
  }
};

/// a - b, exactly; unbounded if it overflows.
template <>
struct DifferenceOf<Ball<DoubleDouble>> {
  static Ball<DoubleDouble> Of(double a, double b) {
    const DoubleDouble difference = TwoSum(a, -b);
    if (!std::isfinite(difference.low)) return Unbounded<DoubleDouble>();
    return {difference, 0};
  }
};

/// x 2^-exponent, rounded to the nearest T: error u |x| or u^2 |x|, kept.
template <class T>
Ball<T> BallOf(const Exact& x, long exponent);

template <>
struct FromExact<Ball<double>> {
  static Ball<double> Of(const Exact& x) { return BallOf<double>(x, 0); }
};

template <>
struct FromExact<Ball<DoubleDouble>> {
  static Ball<DoubleDouble> Of(const Exact& x) {
    return BallOf<DoubleDouble>(x, 0);
  }
};

/// An exact vector of any exponent, rounded once, with a power of two taken
/// out; not all components 0.
template <class T>
ScaledVector<T> ScaleToUnit(const Vec3<Exact>& v);

}  // namespace truelux

#endif  // TRUELUX_EXACT_BALL_RECIPE_H_
