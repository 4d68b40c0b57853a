// SPDX-License-Identifier: GPL-3.0-or-later
// The first stage of a sign: double arithmetic with an error bound.
//
// A quantity is a dot product of two vectors that are themselves known only up
// to an error. All bounds are computed under RoundUpward, where a sum of
// products of non-negative numbers is an upper bound by itself (also when it
// underflows). A bound that is infinite or NaN decides nothing.

#ifndef TRUELUX_EXACT_FILTER_H_
#define TRUELUX_EXACT_FILTER_H_

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "truelux/geometry.h"

#include "exact/rounding.h"
#include "exact/sign.h"

namespace truelux {

/// u of the comments here: |fl(x op y) - x op y| <= u |x op y|, rounding in any
/// one direction.
inline constexpr double kDirectedUnit = 0x1p-52;

/// Relative rounding error of the sum of three products, rounded in any one
/// direction, relative to the sum of absolute values. One rounding for each
/// product and two for the sums: (1 + u)^3 - 1 < 4 u.
inline constexpr double kDotFactor = 4 * kDirectedUnit;

/// Rounding error of two products and their difference, relative to the largest
/// product: 2 u for the products, 2 u (1 + u) for the difference, < 5 u.
inline constexpr double kCrossFactor = 5 * kDirectedUnit;

/// Underflow: a product errs by at most 2^-1074 more, a sum by nothing more;
/// three products.
inline constexpr double kDotFloor = 0x1p-1072;

/// Below this no component has overflowed.
inline constexpr double kNoOverflow = 0x1p1022;

/// An error bound below this means that sum|p_i d_i|, which it holds times
/// kDotFactor, is below 2^1010: no product and no sum has overflowed.
inline constexpr double kNoDotOverflow = 0x1p960;

/// A number with a bound on its absolute error.
struct BoundedValue {
  double value = 0;
  double error = 0;
};

/// A sign if the bound allows one; never zero.
inline std::optional<Sign> TrySign(const BoundedValue& x) {
  if (x.value > x.error) return Sign::kPositive;
  if (-x.value > x.error) return Sign::kNegative;
  return std::nullopt;
}

/// A vector with a bound on the absolute error of each component.
struct ApproxVector {
  double x = 0;
  double y = 0;
  double z = 0;
  double error = 0;
};

/// A direction, ready for FilteredDot.
struct FilteredDirection {
  ApproxVector v;
  double max = 0;  ///< largest |component| of v
};

inline FilteredDirection MakeFilteredDirection(const ApproxVector& v) {
  return {v, std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)})};
}

/// b - a, each component rounded once. Requires RoundUpward. Always inlined: of
/// all filters it is called most, and GCC 12 decides by the size of the file.
[[gnu::always_inline]] inline FilteredDirection FilteredDifference(
    const Point3& a, const Point3& b) {
  assert(IsRoundingUpward());
  FilteredDirection d =
      MakeFilteredDirection({b.x - a.x, b.y - a.y, b.z - a.z, 0});
  // A negative overflow is rounded up to -DBL_MAX: no infinity warns of it.
  d.v.error = d.max < kNoOverflow ? d.max * kDirectedUnit : HUGE_VAL;
  return d;
}

/// a x e. A component is the difference of two products. Let
/// m = max|a~| max|e~|. A product errs by |a~||de| + |e~||da| + |da||de| + u m,
/// and rounding the difference adds 2 u m (1 + u). Requires RoundUpward.
inline ApproxVector FilteredCross(const FilteredDirection& a,
                                  const FilteredDirection& e) {
  assert(IsRoundingUpward());
  const double m = a.max * e.max;
  const double error =
      2 * (a.max * e.v.error + e.max * a.v.error + a.v.error * e.v.error) +
      kCrossFactor * m + kDotFloor;
  return {a.v.y * e.v.z - a.v.z * e.v.y, a.v.z * e.v.x - a.v.x * e.v.z,
          a.v.x * e.v.y - a.v.y * e.v.x,
          error < kNoDotOverflow && m < kNoDotOverflow ? error : HUGE_VAL};
}

/// A plane normal, ready for FilteredDot. With p the true normal, d the true
/// direction, p~ and d~ their approximations with errors e_p and e_d:
///   |p.d - fl(p~.d~)| <= kDotFactor sum|p~_i d~_i| + kDotFloor
///                        + e_p sum|d~_i| + e_d sum|p~_i| + 3 e_p e_d
///                     <= max|d~| a + e_d b + kDotFloor.
struct FilteredPlane {
  ApproxVector v;
  double a = 0;  ///< kDotFactor sum|p~_i| + 3 e_p
  double b = 0;  ///< sum|p~_i| + 3 e_p
};

/// Requires RoundUpward.
inline FilteredPlane MakeFilteredPlane(const ApproxVector& v) {
  assert(IsRoundingUpward());
  const double sum = std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
  return {v, sum * kDotFactor + 3 * v.error, sum + 3 * v.error};
}

/// Requires RoundUpward.
inline BoundedValue FilteredDot(const FilteredPlane& p,
                                const FilteredDirection& d) {
  assert(IsRoundingUpward());
  const double error = d.max * p.a + d.v.error * p.b + kDotFloor;
  return {p.v.x * d.v.x + p.v.y * d.v.y + p.v.z * d.v.z,
          error < kNoDotOverflow ? error : HUGE_VAL};
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_FILTER_H_
