// Planes and directions as balls, scaled so that nothing over- or underflows.

#ifndef TRUELUX_EXACT_BALL_RECIPE_H_
#define TRUELUX_EXACT_BALL_RECIPE_H_

#include "exact/ball.h"
#include "exact/recipe.h"

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

/// A vector known up to a positive factor, and the factor that was taken out:
/// what was meant is 2^exponent * vector; the largest component of vector is
/// in [1/2, 2), the errors are relative to it.
template <class T>
struct ScaledVector {
  Vec3<Ball<T>> vector;
  long exponent = 0;
  /// Every component bounded, not all of them 0.
  bool usable = false;

  /// The largest error of a component.
  [[nodiscard]] double Error() const {
    return std::max({vector.x.error, vector.y.error, vector.z.error});
  }
};

/// v with a power of two taken out.
template <class T>
ScaledVector<T> ScaleToUnit(const Vec3<Ball<T>>& v);

/// The same for an exact vector, of any exponent; not all components 0.
template <class T>
ScaledVector<T> ScaleToUnit(const Vec3<Exact>& v);

}  // namespace truelux

#endif  // TRUELUX_EXACT_BALL_RECIPE_H_
