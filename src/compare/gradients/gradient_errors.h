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

/// One entry per receiver. A receiver passes if E is discontinuous there, or if
/// in every compared channel |value - g| <= tolerance * |g| or, where g is 0,
/// |value| <= tolerance * (the largest |g| of that channel in the table); nothing
/// that is nan or infinite passes.
[[nodiscard]] std::vector<GradientError> ErrorsOf(const GradientData& data,
                                                  double tolerance);

[[nodiscard]] GradientErrorSummary Summarize(
    std::span<const GradientError> errors);

/// The indices of the receivers with the largest excess, at most `most`,
/// largest first; of equal ones the first. Exact ones are left out.
[[nodiscard]] std::vector<std::size_t> WorstOf(
    std::span<const GradientError> errors, std::size_t most);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_ERRORS_H_
