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
/// names. The step is looked for between the size of scene and receivers and
/// 1e-7 of it, on the receivers that are worst: 24 of them, or fewer in a large
/// scene. Across a kink: at least half of the differences' squared error, over
/// at most 48 receivers, is where the gradient or E jumps on the way
/// (kink_crossing.h). Nothing if the best step is at the end of the range; nor,
/// with a note, in scenes of more than 50,000 triangles.
[[nodiscard]] std::optional<GradientHypothesis> FiniteDifferences(
    GradientTrial& trial);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_FINITE_DIFFERENCES_H_
