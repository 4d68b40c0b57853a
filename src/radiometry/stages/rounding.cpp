// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/rounding.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace truelux {
namespace {

/// A result is never negative; a bound of it may round to -0.
double WithoutMinusZero(double x) {
  return x == 0 ? 0.0 : x;
}

}  // namespace

std::optional<double> RoundIfCertain(const Ball<DoubleDouble>& x) {
  if (!IsBounded(x)) return std::nullopt;
  const double high = x.value.high;
  const double low = x.value.low;
  // low + error and low - error with a margin for their own rounding, which
  // is at most u (|low| + error): the sums enclose the ball's low part. high
  // plus either is then rounded once, and rounding is monotone.
  const double error = RoundBoundUp(x.error) + 0x1p-51 * std::fabs(low);
  const double from = high + (low - error);
  const double to = high + (low + error);
  if (from != to || !std::isfinite(to)) return std::nullopt;
  return WithoutMinusZero(to);
}

std::optional<double> RoundIfCertain(const Enclosure& x) {
  const double from = x.lower.ToDouble();
  const double to = x.upper.ToDouble();
  if (from != to) return std::nullopt;
  return WithoutMinusZero(to);
}

std::optional<double> RoundTieToEven(const Enclosure& x) {
  const double from = WithoutMinusZero(x.lower.ToDouble());
  const double to = x.upper.ToDouble();
  if (std::nextafter(from, to) != to) return std::nullopt;
  const bool from_is_even = std::bit_cast<std::uint64_t>(from) % 2 == 0;
  return from_is_even ? from : to;
}

double HalfSpacing(double x) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
  // The spacing above x: 2^-1074 where numbers are subnormal.
  constexpr int kLeastExponent = -1022;
  const int exponent = x == 0 ? kLeastExponent : std::ilogb(x);
  const double half = std::ldexp(1.0, std::max(exponent, kLeastExponent) - 53);
  // Not numeric_limits' least subnormal: -frounding-math has it converted from
  // a long double at run time, which is slow.
  return half > 0 ? half : 0x1p-1074;
}

}  // namespace truelux
