// SPDX-License-Identifier: GPL-3.0-or-later
// How well a hypothesis explains a candidate, beside the plain scene.

#ifndef TRUELUX_COMPARE_MISTAKE_FIT_H_
#define TRUELUX_COMPARE_MISTAKE_FIT_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "truelux/geometry.h"

#include "compare/candidate_errors.h"
#include "compare/mistake_trial.h"

namespace truelux {

/// What a fit knows of one value.
struct FitDistance {
  std::size_t receiver = 0;
  double from_truth = 0;  ///< relative
  double from_predicted = 0;
  bool is_disputed = false;
};

/// A disputed prediction differs from the truth by more than rounding, relative
/// to them, ..
inline constexpr double kRoundingOfSums = 1e-12;
/// .. and by more than so many times the candidate's noise.
inline constexpr double kNoiseTimes = 3;

/// The fit of values by their distances; passing_before and passing_after are
/// left 0. receivers: how many were tried.
[[nodiscard]] MistakeFit FitOfDistances(std::span<const FitDistance> distances,
                                        std::size_t receivers);

/// Whether the hypothesis explains the candidate much better than the plain
/// scene does: at least three receivers are disputed, the mean loss of their
/// values falls to a sixth or less, and that of all values to a quarter at
/// most. For a factor, which noise may blur more: to a half.
[[nodiscard]] bool Explains(const MistakeFit& fit, bool is_factor);

/// How well a mistake explains a candidate, in words.
[[nodiscard]] std::string TextOf(const MistakeFit& fit);

[[nodiscard]] MistakeFit FitOf(const CandidateData& data,
                               const Hypothesis& hypothesis, double tolerance);

/// Whether two hypotheses predict the same, up to rounding.
[[nodiscard]] bool PredictTheSame(const Hypothesis& a, const Hypothesis& b);

/// The factor by which a candidate's values are larger than the truth.
struct FactorFit {
  double factor = 1;
  double standard_error = 0;  ///< of the factor, relative to it
};

/// By the median or by the mean, whichever leaves the smaller loss. Nothing
/// for fewer than three receivers with E > 0 and a finite value, or if the
/// factor is not positive.
[[nodiscard]] std::optional<FactorFit> FitFactor(const CandidateData& data);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_MISTAKE_FIT_H_
