// SPDX-License-Identifier: GPL-3.0-or-later
// From intervals to vectors with an error bound, as filters take them.

#ifndef TRUELUX_EXACT_APPROXIMATION_H_
#define TRUELUX_EXACT_APPROXIMATION_H_

#include <algorithm>
#include <cassert>
#include <cmath>

#include "exact/filter.h"
#include "exact/number.h"
#include "exact/rounding.h"
#include "exact/vec3.h"

namespace truelux {

/// Midpoint and radius of an interval vector. Requires RoundUpward.
inline ApproxVector Approximate(const Vec3<Interval>& v) {
  assert(IsRoundingUpward());
  ApproxVector a;
  const auto midpoint = [&a](const Interval& c) {
    const double m = c.inf() + (c.sup() - c.inf()) * 0.5;
    a.error = std::max({a.error, c.sup() - m, m - c.inf()});
    if (!std::isfinite(m)) a.error = HUGE_VAL;  // max drops a NaN
    return m;
  };
  a.x = midpoint(v.x);
  a.y = midpoint(v.y);
  a.z = midpoint(v.z);
  return a;
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_APPROXIMATION_H_
