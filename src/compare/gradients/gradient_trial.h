// SPDX-License-Identifier: GPL-3.0-or-later
// The receivers on which it is tried whether a known mistake explains a
// candidate's gradients, and how well it does.

#ifndef TRUELUX_COMPARE_GRADIENTS_GRADIENT_TRIAL_H_
#define TRUELUX_COMPARE_GRADIENTS_GRADIENT_TRIAL_H_

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "compare/gradients/fixed_visibility.h"
#include "compare/gradients/gradient_data.h"
#include "compare/mistake_fit.h"
#include "compare/mistake_trial.h"
#include "compare/receivers_without.h"

namespace truelux {

/// The derivatives of a scene at some receivers, one entry each, certified, with
/// Ke read as it is in the comparison. May throw to end everything.
using DerivativeEvaluator = std::function<std::vector<Derivatives>(
    const Scene&, std::span<const Receiver>)>;

/// Who finds what mistakes need; as SceneEvaluator.
struct GradientEvaluators {
  SceneEvaluator irradiances;
  DerivativeEvaluator derivatives;
};

/// What a mistake would make of the receivers of a trial.
struct GradientHypothesis {
  std::string mistake{};  ///< its name
  std::string sentence;   ///< what the candidate does, without a full stop
  /// One per receiver, compared channels; nan where it says nothing.
  std::vector<GradientRow> predicted;
  std::optional<double> factor{};  ///< predicted = factor * truth, if so
};

/// Sums over the sources, each as if it were alone; all channels, one entry per
/// receiver of a trial.
struct AloneSums {
  std::vector<GradientRow> gradients;  ///< of all
  /// Each times the share of its light that is visible.
  std::vector<GradientRow> by_shares;
  /// The sum of all times the share of the whole light that is visible.
  std::vector<GradientRow> by_share;
};

/// What all mistakes are tried with.
class GradientTrial {
 public:
  /// oracle: over the compared scene, with the comparison's emission. data: the
  /// receivers of the trial. All must outlive the object.
  GradientTrial(const Oracle& oracle, const GradientData& data,
                const GradientEvaluators& evaluate);

  [[nodiscard]] const Oracle& oracle() const { return oracle_; }

  [[nodiscard]] const Scene& scene() const { return oracle_.scene(); }

  [[nodiscard]] const GradientData& data() const { return data_; }

  [[nodiscard]] const GradientEvaluators& evaluate() const { return evaluate_; }

  /// Gradients of the compared channels, nan where E is discontinuous.
  [[nodiscard]] std::vector<GradientRow> GradientsOf(
      std::span<const Derivatives> derivatives) const;

  /// The gradients of the scene at other receivers, one for each of the trial.
  [[nodiscard]] std::vector<GradientRow> GradientsAt(
      std::span<const Receiver> receivers) const;

  /// The sources one by one; found once. Nothing, and a note, for more than 64
  /// sources or where sources times faces are more than five million.
  const std::optional<AloneSums>& Alone();

  /// FixedVisibilityOf the trial; found once.
  const std::optional<FixedVisibility>& Fixed();

  /// What was left out to save time, for the reader; added by mistakes.
  std::vector<std::string> notes;

 private:
  [[nodiscard]] std::optional<AloneSums> FindAloneSums();
  [[nodiscard]] std::vector<Derivatives> WithFaceAlone(int face);

  const Oracle& oracle_;
  const GradientData& data_;
  const GradientEvaluators& evaluate_;
  ReceiversWithout receivers_without_;
  // The inner one is nothing where it could not be found.
  std::optional<std::optional<AloneSums>> alone_;
  std::optional<std::optional<FixedVisibility>> fixed_;
};

/// As for irradiances (mistake_fit.h), with lengths of vectors and of
/// differences in place of absolute values.
[[nodiscard]] MistakeFit FitOf(const GradientData& data,
                               const GradientHypothesis& hypothesis,
                               double tolerance);

/// Whether two hypotheses predict the same, up to rounding.
[[nodiscard]] bool PredictTheSame(const GradientHypothesis& a,
                                  const GradientHypothesis& b);

/// The factor by which a candidate's gradients are longer than the truth, with
/// the sign; by the median or the mean, whichever leaves the smaller loss.
/// Nothing for fewer than three receivers with a gradient other than 0, or if
/// the factor is 0.
[[nodiscard]] std::optional<FactorFit> FitFactor(const GradientData& data);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_TRIAL_H_
