// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of an expression that is written once for both number types.

#ifndef TRUELUX_EXACT_DECIDE_H_
#define TRUELUX_EXACT_DECIDE_H_

#include "exact/number.h"
#include "exact/sign.h"

namespace truelux {

/// The sign of what `value` gives: by intervals or, where they cannot tell, by
/// exact numbers. value: a callable value.operator()<NT>() that returns the
/// same number in NT, whichever NT is. Requires a RoundUpward object in the
/// calling thread.
template <class Value>
Sign Decide(const Value& value) {
  const auto known = TrySign(value.template operator()<Interval>());
  return known ? *known : SignOf(value.template operator()<Exact>());
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_DECIDE_H_
