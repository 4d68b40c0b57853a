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

/// The distance of a candidate's value from the truth is measured by the
/// larger of truth and prediction, in absolute value (where both are 0, by the
/// largest truth of its channel); that from the prediction by the prediction,
/// or by 1e-9 of the former if that is more: values at or above the threshold
/// are not counted as dark. For a constant factor either is measured by itself. The loss of a
/// value is the square of its distance, at most 1.
///
/// A value is disputed if prediction and truth differ by more than the
/// candidate's noise can: 1e-12, and three times the median distance from the
/// prediction where that is not 0; for a constant factor wherever the truth is
/// not 0.
struct MistakeFit {
  std::size_t receivers = 0;  ///< tried
  std::size_t disputed = 0;   ///< of these, with a disputed value
  /// Over the disputed values: the median distance from the truth and from the
  /// prediction.
  double median_before = 0;
  double median_after = 0;
  /// The mean loss of all values.
  double loss_before = 0;
  double loss_after = 0;
  /// The mean loss of the disputed values.
  double disputed_loss_before = 0;
  double disputed_loss_after = 0;
  std::size_t passing_before = 0;  ///< receivers that pass
  std::size_t passing_after = 0;   ///< .. if the prediction were the truth

  /// Whether the hypothesis explains the candidate much better than the plain
  /// scene does: at least three receivers are disputed, the mean loss of their
  /// values falls to a sixth or less, and that of all values to a quarter at
  /// most. For a factor, which noise may blur more: to a half.
  [[nodiscard]] bool Explains(bool is_factor) const;
};

/// The fit of values by their distances; passing_before and passing_after are
/// left 0. receivers: how many were tried.
[[nodiscard]] MistakeFit FitOfDistances(std::span<const FitDistance> distances,
                                        std::size_t receivers);

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
