// SPDX-License-Identifier: GPL-3.0-or-later
// From enclosures to the binary64 nearest to each number.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_CERTIFY_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_CERTIFY_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "exact/arb_real.h"

namespace truelux {

/// Numbers and their bounds.
struct CertifiedNumbers {
  std::vector<double> values;
  std::vector<double> bounds;
  int undecided = 0;  ///< given as 0, with a bound that says how near that is
};

/// Where numbers come from.
struct NumberSource {
  /// Enclosures of all of them at a precision [bits].
  std::function<std::vector<ArbReal>(slong precision)> at;
  /// Whether a number is exactly zero. enclosure: it holds 0.
  std::function<bool(std::size_t number, const ArbReal& enclosure)> is_zero;
};

/// Rounds the numbers that are `open`: with 128, 256, .. bits until each rounds
/// one way or is known to be zero; what 4096 bits leave open is 0 with its
/// bound, and counted. The others are 0.
CertifiedNumbers Certify(const NumberSource& source, std::vector<bool> open);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_CERTIFY_H_
