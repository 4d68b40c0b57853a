// SPDX-License-Identifier: GPL-3.0-or-later
// How far a candidate's gradients are from the truth, receiver by receiver and
// in a few numbers.

#ifndef TRUELUX_COMPARE_GRADIENTS_GRADIENT_ERRORS_H_
#define TRUELUX_COMPARE_GRADIENTS_GRADIENT_ERRORS_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compare/gradients/gradient_data.h"

namespace truelux {

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

/// One entry per receiver. A receiver passes if E is discontinuous there, or if
/// in every compared channel |value - g| <= tolerance * |g| or, where g is 0,
/// |value| <= tolerance * (the largest |g| of that channel in the table); nothing
/// that is nan or infinite passes.
[[nodiscard]] std::vector<GradientError> ErrorsOf(const GradientData& data,
                                                  double tolerance);

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

[[nodiscard]] GradientErrorSummary Summarize(
    std::span<const GradientError> errors);

/// The indices of the receivers with the largest excess, at most `most`,
/// largest first; of equal ones the first. Exact ones are left out.
[[nodiscard]] std::vector<std::size_t> WorstOf(
    std::span<const GradientError> errors, std::size_t most);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_ERRORS_H_
