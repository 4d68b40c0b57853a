// SPDX-License-Identifier: GPL-3.0-or-later
// What the working types of frames, Ball<DoubleDouble> and Multiprecision, have
// in common, under the same names.

#ifndef TRUELUX_RADIOMETRY_WORKING_NUMBER_H_
#define TRUELUX_RADIOMETRY_WORKING_NUMBER_H_

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "exact/ball_vector.h"
#include "exact/numeric.h"
#include "exact/vec3.h"

namespace truelux {

/// What an exact number is rounded to on its way to a double-double.
inline constexpr mpfr_prec_t kConversionBits = 160;

/// A double as a working number, exactly.
template <class W>
W FromDouble(double x) {
  if constexpr (std::is_same_v<W, Multiprecision>) {
    return Make<Multiprecision>(x);
  } else {
    return W(x);
  }
}

/// Whether x 2^exponent is a normal number, or 0.
inline bool StaysNormal(double x, double power_of_two) {
  return x == 0 || std::fabs(x * power_of_two) >= 0x1p-1000;
}

/// x 2^exponent.
inline Ball<DoubleDouble> TimesTwoTo(const Ball<DoubleDouble>& x,
                                     int exponent) {
  const double factor = PowerOfTwo(exponent);
  Ball<DoubleDouble> scaled = truelux::Scaled(x, factor);
  // Exact numbers stay exact: formulas ask for exact zeros.
  if (x.error == 0 && StaysNormal(x.value.high, factor) &&
      StaysNormal(x.value.low, factor)) {
    scaled.error = 0;
  }
  return scaled;
}

/// x, which is known not to be negative.
inline Ball<DoubleDouble> NotBelowZero(const Ball<DoubleDouble>& x) {
  return ClampToNonNegative(x);
}

/// x, which is known not to be negative.
inline Multiprecision NotBelowZero(const Multiprecision& x) {
  return NonNegative(x);
}

/// x 2^exponent.
inline Multiprecision TimesTwoTo(Multiprecision x, int exponent) {
  mpfr_mul_2si(x.get(), x.get(), exponent, MPFR_RNDN);
  return x;
}

/// v 2^exponent.
template <class W>
Vec3<W> TimesTwoTo(const Vec3<W>& v, int exponent) {
  return {TimesTwoTo(v.x, exponent), TimesTwoTo(v.y, exponent),
          TimesTwoTo(v.z, exponent)};
}

/// The value of a working number, without its bound.
inline const Multiprecision& Middle(const Multiprecision& x) {
  return x;
}

/// The value of a working number, without its bound.
inline Multiprecision Middle(const Ball<DoubleDouble>& x) {
  return Multiprecision(kConversionBits, x.value.high) +
         Multiprecision(kConversionBits, x.value.low);
}

/// The same direction with a largest component in [1/2, 1).
inline Vec3<Multiprecision> Normalized(const Vec3<Multiprecision>& v) {
  mpfr_exp_t largest = mpfr_get_emin();
  for (const Multiprecision* x : {&v.x, &v.y, &v.z}) {
    if (mpfr_regular_p(x->get()) != 0) {
      largest = std::max(largest, mpfr_get_exp(x->get()));
    }
  }
  return TimesTwoTo(v, static_cast<int>(-largest));
}

/// A number of kConversionBits as a ball.
inline Ball<DoubleDouble> BallOfRounded(Multiprecision x) {
  if (IsZero(x)) return Ball<DoubleDouble>(0.0);
  const double high = x.ToDouble();
  mpfr_sub_d(x.get(), x.get(), high, MPFR_RNDN);
  return {{high, x.ToDouble()}, RoundBoundUp(0x1p-104 * std::fabs(high))};
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_WORKING_NUMBER_H_
