// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a candidate's gradients are differences of irradiances, with which
// step, and whether the step crosses kinks.

#ifndef TRUELUX_COMPARE_GRADIENTS_FINITE_DIFFERENCES_H_
#define TRUELUX_COMPARE_GRADIENTS_FINITE_DIFFERENCES_H_

#include <optional>
#include <string_view>

#include "compare/gradients/gradient_trial.h"

namespace truelux {

inline constexpr std::string_view kDifferencesAcrossKinks =
    "finite differences across a kink";
inline constexpr std::string_view kLongDifferences =
    "finite differences with a long step";

/// Central and one-sided differences of the certified E along the axes, with
/// the step that explains the candidate best; its mistake is one of the two
/// names. The step is looked for between a tenth and a millionth of the scene's
/// size, on the 24 receivers that are worst. Across a kink: at half or more of
/// the receivers where the difference is wrong, it is no less wrong with a
/// quarter of the step, or exact then, as it cannot be where E is smooth.
/// Nothing if no step explains anything.
[[nodiscard]] std::optional<GradientHypothesis> FiniteDifferences(
    GradientTrial& trial);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_FINITE_DIFFERENCES_H_
