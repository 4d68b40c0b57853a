// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/compare_gradients.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"

#include "base/stop.h"
#include "compare/candidate_report.h"
#include "compare/diagnosis.h"
#include "compare/explanation.h"
#include "compare/gradients/finite_differences.h"
#include "compare/gradients/gradient_mistakes.h"
#include "compare/receivers_without.h"
#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

using GradientExplanation = Explanation<GradientHypothesis>;

constexpr DerivativeOptions kGradientOnly = {.sphere = false,
                                             .jacobian = false};

std::vector<Derivatives> DerivativesOf(const Oracle& oracle,
                                       std::span<const Receiver> receivers,
                                       const CompareSettings& settings) {
  std::vector<Derivatives> all(receivers.size());
  Progress progress(receivers.size(), kReceivers, settings.watch);
  ForEachInParallel(receivers.size(), settings.threads, progress,
                    [&](std::size_t i) {
                      all[i] = oracle.Derivatives(receivers[i], kGradientOnly);
                    });
  return all;
}

/// The truth for every receiver, one block after the other: derivatives are
/// large.
void FindTruth(const Oracle& oracle, const CompareSettings& settings,
               GradientData& data) {
  data.truth.resize(data.receivers.size());
  Progress progress(data.receivers.size(), kReceivers, settings.watch);
  ForEachInParallel(
      data.receivers.size(), settings.threads, progress, [&](std::size_t i) {
        data.truth[i] =
            TruthFor(data, oracle.Derivatives(data.receivers[i], kGradientOnly),
                     data.values[i]);
      });
}

void FindWorst(const Oracle& oracle, const CompareSettings& settings,
               GradientReport& report) {
  const DetailFinder finder(report.scene);
  for (const std::size_t i : WorstOf(report.errors, kMostWorstCandidates))
    report.worst.push_back({i, {}, {}});
  Progress progress(report.worst.size(), kReceivers, settings.watch);
  ForEachInParallel(
      report.worst.size(), settings.threads, progress, [&](std::size_t k) {
        WorstGradient& worst = report.worst[k];
        const Receiver& receiver = report.data.receivers[worst.receiver];
        worst.detail = finder.Find(receiver, true);
        worst.kinks = oracle.Derivatives(receiver, kGradientOnly).kinks;
      });
}

/// As many failing as passing receivers, if there are, spread evenly.
std::vector<std::size_t> TrialReceivers(std::span<const GradientError> errors) {
  std::vector<CandidateError> plain(errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
    plain[i].passes = errors[i].passes;
  return TrialReceivers(plain, kMostTrialReceivers);
}

/// That the receivers are what is wrong. Has no mistake's name.
std::optional<GradientHypothesis> OnFaces(const GradientTrial& trial) {
  const auto receivers =
      ReceiversOnFaces(trial.scene(), trial.data().receivers);
  if (!receivers) return std::nullopt;
  return GradientHypothesis{
      .sentence =
          "the candidate agrees when the receivers lie on their faces, "
          "as --on-face auto takes them",
      .predicted = trial.GradientsAt(*receivers)};
}

void TryIt(GradientHypothesis hypothesis, const GradientData& data,
           double tolerance, std::vector<GradientExplanation>& explanations) {
  const MistakeFit fit = FitOf(data, hypothesis, tolerance);
  if (Explains(fit, hypothesis.factor.has_value()))
    explanations.push_back({std::move(hypothesis), fit});
}

std::vector<GradientExplanation> ExplanationsOf(
    GradientTrial& trial, double tolerance, std::vector<std::string>& tried) {
  std::vector<GradientExplanation> explanations;
  // No mistake, and before all that predict the same.
  if (std::optional<GradientHypothesis> on_faces = OnFaces(trial))
    TryIt(std::move(*on_faces), trial.data(), tolerance, explanations);
  for (const GradientMistake& mistake : GradientMistakes()) {
    tried.emplace_back(mistake.name);
    for (GradientHypothesis& hypothesis : mistake.hypotheses(trial)) {
      hypothesis.mistake = mistake.name;
      TryIt(std::move(hypothesis), trial.data(), tolerance, explanations);
    }
  }
  if (!explanations.empty()) return explanations;
  tried.emplace_back(kDifferencesAcrossKinks);
  tried.emplace_back(kLongDifferences);
  if (auto differences = FiniteDifferences(trial))
    TryIt(std::move(*differences), trial.data(), tolerance, explanations);
  return explanations;
}

}  // namespace

Diagnosis DiagnoseGradients(const Oracle& oracle, const GradientData& data,
                            std::span<const GradientError> errors,
                            double tolerance,
                            const GradientEvaluators& evaluate) {
  Diagnosis diagnosis;
  if (std::ranges::all_of(errors, &GradientError::passes)) {
    diagnosis.text = "every receiver passes";
    return diagnosis;
  }
  const GradientData sample = SomeOf(data, TrialReceivers(errors));
  diagnosis.receivers = sample.receivers.size();
  GradientTrial trial(oracle, sample, evaluate);
  const std::vector<GradientExplanation> explanations =
      ExplanationsOf(trial, tolerance, diagnosis.tried);
  diagnosis.notes = trial.notes;
  if (explanations.empty()) {
    diagnosis.verdict = Verdict::kUnexplained;
    diagnosis.text = "no classic mistake explains the candidate";
  } else {
    NameExplanation<GradientHypothesis>(explanations, diagnosis);
  }
  return diagnosis;
}

GradientReport CompareGradientData(const Scene& scene, GradientData data,
                                   const CompareSettings& settings) {
  GradientReport report;
  report.scene = scene;
  report.emission = settings.truth.emission;
  report.tolerance = settings.tolerance;
  report.data = std::move(data);
  const OracleOptions oracle_options = {.emission = report.emission,
                                        .stop = settings.watch.stop};
  const Oracle oracle(scene, oracle_options);
  FindTruth(oracle, settings, report.data);
  report.errors = ErrorsOf(report.data, settings.tolerance);
  report.summary = Summarize(report.errors);
  if (!WorstOf(report.errors, 1).empty()) FindWorst(oracle, settings, report);
  const GradientEvaluators evaluate = {
      [&](const Scene& variant, std::span<const Receiver> receivers) {
        StopIfAsked(settings.watch.stop);
        return IrradiancesOf(Oracle(variant, oracle_options), receivers,
                             settings);
      },
      [&](const Scene& variant, std::span<const Receiver> receivers) {
        StopIfAsked(settings.watch.stop);
        return DerivativesOf(Oracle(variant, oracle_options), receivers,
                             settings);
      }};
  report.diagnosis = DiagnoseGradients(oracle, report.data, report.errors,
                                       settings.tolerance, evaluate);
  return report;
}

}  // namespace truelux
