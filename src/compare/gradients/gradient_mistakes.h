// SPDX-License-Identifier: GPL-3.0-or-later
// The classic mistakes of programs that differentiate irradiance.

#ifndef TRUELUX_COMPARE_GRADIENTS_GRADIENT_MISTAKES_H_
#define TRUELUX_COMPARE_GRADIENTS_GRADIENT_MISTAKES_H_

#include <span>
#include <string_view>
#include <vector>

#include "compare/gradients/gradient_trial.h"

namespace truelux {

/// A mistake by its name, and what it would make of a trial's receivers: one
/// hypothesis for each way to make it, none where it could not be told.
/// Whoever calls it fills in GradientHypothesis::mistake.
struct GradientMistake {
  std::string_view name;
  std::vector<GradientHypothesis> (*hypotheses)(GradientTrial& trial);
};

/// All that are known. Where two explain a candidate equally, the first one is
/// named. That differences cross kinks is not among them
/// (finite_differences.h): it takes longer, and is tried if nothing else
/// explains the candidate.
[[nodiscard]] std::span<const GradientMistake> GradientMistakes();

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_MISTAKES_H_
