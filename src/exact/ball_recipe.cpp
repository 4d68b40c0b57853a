// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/ball_recipe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

#include "exact/exact_conversion.h"
#include "exact/multiprecision.h"

namespace truelux {
namespace {

/// Enough for a double-double: 2^-128 is below u^2 by 22 bits.
constexpr mpfr_prec_t kConversionBits = 128;

Multiprecision Rounded(const Exact& x) {
  return MultiprecisionOf(kConversionBits, x);
}

/// The error of a conversion is at most u |x| (u^2 |x| for double-double,
/// twice that where the low part is subnormal, which kUnderflow covers), and
/// 2^-128 |x| for the first rounding.
template <class T>
Ball<T> BallOfRounded(Multiprecision x, long exponent) {
  mpfr_mul_2si(x.get(), x.get(), -exponent, MPFR_RNDN);
  const double high = x.ToDouble();
  if (!std::isfinite(high)) return Unbounded<T>();
  mpfr_sub_d(x.get(), x.get(), high, MPFR_RNDN);
  const double low = x.ToDouble();
  if constexpr (std::is_same_v<T, double>) {
    return {high, RoundBoundUp(std::fabs(low) * (1 + 0x1p-50) +
                               0x1p-127 * std::fabs(high))};
  } else {
    return {{high, low},
            RoundBoundUp(kUnitSquared * (1 + 0x1p-20) * std::fabs(high))};
  }
}

}  // namespace

template <class T>
Ball<T> BallOf(const Exact& x, long exponent) {
  return BallOfRounded<T>(Rounded(x), exponent);
}

template <class T>
ScaledVector<T> ScaleToUnit(const Vec3<Exact>& v) {
  assert(!IsZero(v));
  Multiprecision x = Rounded(v.x);
  Multiprecision y = Rounded(v.y);
  Multiprecision z = Rounded(v.z);
  mpfr_exp_t exponent = mpfr_get_emin();
  for (const Multiprecision* c : {&x, &y, &z}) {
    if (mpfr_regular_p(c->get()) != 0) {
      exponent = std::max(exponent, mpfr_get_exp(c->get()));
    }
  }
  // MPFR's significands are in [1/2, 1).
  exponent -= 1;
  const Ball<T> rounded_x = BallOfRounded<T>(std::move(x), exponent);
  const Ball<T> rounded_y = BallOfRounded<T>(std::move(y), exponent);
  const Ball<T> rounded_z = BallOfRounded<T>(std::move(z), exponent);
  const Components<T> value{rounded_x.value, rounded_y.value, rounded_z.value};
  return {{value, LengthOf(value),
           RoundBoundUp(rounded_x.error + rounded_y.error + rounded_z.error)},
          static_cast<int>(exponent)};
}

template Ball<double> BallOf<double>(const Exact&, long);
template Ball<DoubleDouble> BallOf<DoubleDouble>(const Exact&, long);
template ScaledVector<double> ScaleToUnit(const Vec3<Exact>&);
template ScaledVector<DoubleDouble> ScaleToUnit(const Vec3<Exact>&);

}  // namespace truelux
