// SPDX-License-Identifier: GPL-3.0-or-later
// Where an edge through the view crosses a plane, and the order of such
// crossings as far as double arithmetic can tell.

#ifndef TRUELUX_EXACT_CROSSING_H_
#define TRUELUX_EXACT_CROSSING_H_

#include <cassert>
#include <cmath>
#include <optional>

#include "base/ids.h"
#include "exact/filter.h"
#include "exact/rounding.h"
#include "exact/sign.h"

namespace truelux {

/// A sign together with the value the filter found for it.
struct Side {
  Sign sign = Sign::kZero;
  BoundedValue value;
};

/// Where an edge u -> v through the view crosses a plane A that has u and v
/// strictly on opposite sides. Crossings of one edge are in the order of
/// their parameters |A.u| / (|A.u| + |A.v|), which is known up to an error.
struct Crossing {
  ViewPlaneId plane;        ///< A
  Sign from = Sign::kZero;  ///< of A . u; that of A . v is the opposite
  double parameter = 0;
  double error = HUGE_VAL;  ///< bound on |parameter - the true one|
};

/// Where an edge u -> v crosses a plane.
///
/// The parameter f / (f + g), f = |A.u|, g = |A.v|. With f~, g~ and bounds
/// e_f < f~, e_g < g~ the true (f, g) lie in a box with f + g >= s - e, where
/// s = f~ + g~ and e = e_f + e_g; there the gradient is (g, -f) / (f + g)^2, so
///   |error| <= (e_f (g~ + e_g) + e_g (f~ + e_f)) / (s - e)^2,
/// at most 1.01 times the same over s^2 if e <= s/1024. The quotient is rounded
/// three times (s, 1/s, the product), each by kDirectedUnit: 4 kDirectedUnit covers them.
/// Requires RoundUpward; an infinite or NaN error tells nothing.
inline Crossing MakeCrossing(ViewPlaneId plane, const Side& from,
                             const Side& to) {
  assert(IsRoundingUpward());
  const double f = std::fabs(from.value.value);
  const double g = std::fabs(to.value.value);
  const double e_f = from.value.error;
  const double e_g = to.value.error;
  const double s = f + g;
  const double q = 1 / s;
  Crossing crossing{plane, from.sign, f * q, HUGE_VAL};
  if (e_f < f && e_g < g && (e_f + e_g) * 1024 <= s) {
    crossing.error =
        1.01 * ((e_f * q) * ((g + e_g) * q) + (e_g * q) * ((f + e_f) * q)) +
        4 * kDirectedUnit * crossing.parameter + kDotFloor;
  }
  return crossing;
}

/// Order along the edge, negative if a comes first, if the errors allow one;
/// never zero. Requires RoundUpward.
inline std::optional<Sign> TryOrder(const Crossing& a, const Crossing& b) {
  assert(IsRoundingUpward());
  const double error = a.error + b.error;
  // Rounded up: what is negative with the error added is so in truth.
  if (a.parameter - b.parameter + error < 0) return Sign::kNegative;
  if (b.parameter - a.parameter + error < 0) return Sign::kPositive;
  return std::nullopt;
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_CROSSING_H_
