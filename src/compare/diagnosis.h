// SPDX-License-Identifier: GPL-3.0-or-later
// Why a candidate fails: a classic mistake, noise, or nothing that is known.

#ifndef TRUELUX_COMPARE_DIAGNOSIS_H_
#define TRUELUX_COMPARE_DIAGNOSIS_H_

#include <cstddef>
#include <optional>
#include <span>

#include "truelux/comparison.h"
#include "truelux/scene.h"

#include "compare/candidate_errors.h"
#include "compare/mistake_trial.h"

namespace truelux {

/// The largest number of receivers that mistakes are tried on.
inline constexpr std::size_t kMostTrialReceivers = 256;

/// scene: the compared one, with unit exitances if form factors are compared.
/// errors: ErrorsOf(data, tolerance). What `evaluate` throws ends it.
[[nodiscard]] Diagnosis Diagnose(const Scene& scene, const CandidateData& data,
                                 std::span<const CandidateError> errors,
                                 double tolerance, const TruthOptions& options,
                                 const SceneEvaluator& evaluate);

/// Nothing if no receiver is lit.
[[nodiscard]] std::optional<NoiseTraits> NoiseTraitsOf(
    const CandidateData& data, std::span<const CandidateError> errors);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_DIAGNOSIS_H_
