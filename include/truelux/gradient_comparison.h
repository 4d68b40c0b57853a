// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison with another program's gradients says (compare.h).

#ifndef TRUELUX_GRADIENT_COMPARISON_H_
#define TRUELUX_GRADIENT_COMPARISON_H_

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "truelux/comparison.h"
#include "truelux/derivatives.h"
#include "truelux/geometry.h"

namespace truelux {

/// dE/dr of up to three channels, the normal fixed [W/m^3].
using GradientRow = std::array<Vector3, 3>;

/// One receiver of a candidate.
struct GradientError {
  bool has_gradient = true;  ///< E is not discontinuous there
  bool at_kink = false;
  bool is_flat = false;    ///< the gradient is 0 in all compared channels
  bool no_number = false;  ///< some component is nan or infinite
  bool exact = false;      ///< all components are the certified numbers
  bool passes = false;
  /// The largest over the channels of |value - g| / |g| or, where g is 0, of
  /// |value| / (the largest |g| of the channel in the table): what is held
  /// against the tolerance. Infinite for nan and for what is infinite.
  double excess = 0;
  double absolute = 0;  ///< the largest |value - g| [W/m^3]
  /// Of the channel that excess is of, where g is not 0: the angle between
  /// value and g [rad], and (|value| - |g|) / |g|.
  double angle = 0;
  double lengthening = 0;
};

/// A candidate in a few numbers. Every receiver is without a gradient, without
/// a number, flat (g = 0), or none of these.
struct GradientErrorSummary {
  std::size_t receivers = 0;
  std::size_t discontinuous = 0;  ///< not compared
  std::size_t no_number = 0;
  std::size_t flat = 0;
  std::size_t sloping = 0;
  std::size_t kinks = 0;  ///< of the flat and the sloping
  std::size_t flat_exact = 0;
  std::size_t flat_failing = 0;
  std::size_t sloping_exact = 0;
  std::size_t sloping_failing = 0;

  /// Of one size of the sloping receivers' errors.
  struct Quantiles {
    double median = 0;
    double percentile_95 = 0;
    double percentile_99 = 0;
    double max = 0;
  };

  /// Nothing if no receiver is sloping.
  std::optional<Quantiles> relative;
  std::optional<Quantiles> angle;        ///< [rad]
  std::optional<Quantiles> lengthening;  ///< its absolute value
  double mean_lengthening = 0;           ///< > 0: too long
  double max_absolute = 0;               ///< of flat and sloping [W/m^3]
  double max_flat_absolute = 0;          ///< [W/m^3]

  [[nodiscard]] std::size_t failing() const {
    return flat_failing + sloping_failing + no_number;
  }

  /// Whether some receiver has a gradient.
  [[nodiscard]] bool compares_anything() const {
    return discontinuous < receivers;
  }
};

/// What is known of one receiver's gradient.
struct GradientTruth {
  Smoothness smoothness = Smoothness::kC1;
  /// The certified gradient of the compared channels; at a kink that one of the
  /// generalized gradients that is nearest to the candidate's. Without meaning
  /// if E is discontinuous.
  GradientRow gradient{};
};

/// A candidate's gradients held against the truth.
struct GradientComparison : ComparisonReport {
  std::vector<GradientTruth> truth;   ///< one per receiver
  std::vector<GradientError> errors;  ///< one per receiver
  GradientErrorSummary summary;

  /// Whether some receiver has a gradient, and all that have are within the
  /// tolerance.
  [[nodiscard]] bool passes() const {
    return summary.failing() == 0 && summary.compares_anything();
  }
};

}  // namespace truelux

#endif  // TRUELUX_GRADIENT_COMPARISON_H_
