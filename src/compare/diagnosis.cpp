// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "compare/explanation.h"
#include "compare/mistakes.h"
#include "text/number_text.h"

namespace truelux {
namespace {

using ValueExplanation = Explanation<Hypothesis>;

/// That the receivers are what is wrong. Has no mistake's name.
std::optional<Hypothesis> OnFaces(const MistakeTrial& trial) {
  auto predicted = trial.ValuesOnFaces();
  if (!predicted) return std::nullopt;
  return Hypothesis{
      .sentence =
          "the candidate agrees when the receivers lie on their faces, "
          "as --on-face auto takes them",
      .predicted = std::move(*predicted)};
}

std::vector<ValueExplanation> ExplanationsOf(MistakeTrial& trial,
                                             double tolerance,
                                             std::vector<std::string>& tried) {
  std::vector<ValueExplanation> explanations;
  // No mistake, and before all that predict the same.
  if (std::optional<Hypothesis> on_faces = OnFaces(trial)) {
    const MistakeFit fit = FitOf(trial.data(), *on_faces, tolerance);
    if (Explains(fit, false))
      explanations.push_back({std::move(*on_faces), fit});
  }
  for (const Mistake& mistake : Mistakes()) {
    tried.emplace_back(mistake.name);
    for (Hypothesis& hypothesis : mistake.hypotheses(trial)) {
      hypothesis.mistake = mistake.name;
      const MistakeFit fit = FitOf(trial.data(), hypothesis, tolerance);
      if (Explains(fit, hypothesis.factor.has_value()))
        explanations.push_back({std::move(hypothesis), fit});
    }
  }
  return explanations;
}

std::string NoiseText(const NoiseTraits& noise) {
  return fmt::format("mean signed error {}{} +- {} over {} lit receivers",
                     noise.bias < 0 ? "-" : "+",
                     ScientificText(std::abs(noise.bias), 1),
                     ScientificText(noise.standard_error, 1), noise.receivers);
}

double MeanRelativeError(const Rgb& value, const Rgb& truth) {
  double sum = 0;
  double channels = 0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    if (!(truth[c] > 0)) continue;
    sum += (value[c] - truth[c]) / truth[c];
    channels += 1;
  }
  return sum / channels;
}

/// Whether the sum of some numbers is 0 up to three times its standard error.
bool SumsToZero(std::span<const double> values) {
  double sum = 0;
  double squares = 0;
  for (const double v : values) {
    sum += v;
    squares += v * v;
  }
  return sum * sum <= 9 * squares;
}

bool AffectsMost(std::span<const double> errors, double size) {
  constexpr double kSmall = 0.02;
  const auto affected = std::ranges::count_if(
      errors, [&](double e) { return std::abs(e) > kSmall * size; });
  return 2 * affected > std::ssize(errors);
}

bool HasBothSigns(std::span<const double> errors) {
  const auto positive =
      std::ranges::count_if(errors, [](double e) { return e > 0; });
  const auto negative =
      std::ranges::count_if(errors, [](double e) { return e < 0; });
  return 10 * std::min(positive, negative) >= std::ssize(errors);
}

}  // namespace

std::optional<NoiseTraits> NoiseTraitsOf(
    const CandidateData& data, std::span<const CandidateError> errors) {
  std::vector<double> relative;
  std::vector<double> absolute;
  bool all_numbers = true;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const CandidateError& e = errors[i];
    if (e.no_number || std::isinf(e.excess) || (e.is_dark && !e.passes)) {
      all_numbers = false;
      continue;
    }
    if (e.is_dark) continue;
    relative.push_back(MeanRelativeError(data.values[i], data.truth[i]));
    absolute.push_back(data.values[i][0] - data.truth[i][0]);
  }
  if (relative.empty()) return std::nullopt;
  NoiseTraits noise;
  noise.receivers = relative.size();
  const auto count = static_cast<double>(relative.size());
  double squares = 0;
  for (const double e : relative) {
    noise.bias += e / count;
    squares += e * e / count;
  }
  noise.size = std::sqrt(squares);
  noise.standard_error =
      std::sqrt(std::max(0.0, squares - noise.bias * noise.bias) / count);
  constexpr std::size_t kFewest = 8;
  noise.looks_unbiased = all_numbers && noise.receivers >= kFewest &&
                         noise.size <= 1 &&
                         std::abs(noise.bias) <= 3 * noise.standard_error &&
                         SumsToZero(absolute) && HasBothSigns(relative) &&
                         AffectsMost(relative, noise.size);
  return noise;
}

Diagnosis Diagnose(const Scene& scene, const CandidateData& data,
                   std::span<const CandidateError> errors, double tolerance,
                   const TruthOptions& options,
                   const SceneEvaluator& evaluate) {
  Diagnosis diagnosis;
  if (std::ranges::all_of(errors, &CandidateError::passes)) {
    diagnosis.text = "every receiver passes";
    return diagnosis;
  }
  diagnosis.noise = NoiseTraitsOf(data, errors);
  const CandidateData sample =
      SomeOf(data, TrialReceivers(errors, kMostTrialReceivers));
  diagnosis.receivers = sample.receivers.size();
  MistakeTrial trial(scene, sample, options, evaluate);
  std::vector<ValueExplanation> explanations =
      ExplanationsOf(trial, tolerance, diagnosis.tried);
  diagnosis.notes = trial.notes;
  if (!explanations.empty()) {
    NameExplanation<Hypothesis>(explanations, diagnosis);
    return diagnosis;
  }
  if (diagnosis.noise && diagnosis.noise->looks_unbiased) {
    diagnosis.verdict = Verdict::kNoise;
    diagnosis.text = fmt::format(
        "no classic mistake; the errors look like unbiased noise of relative "
        "size {} ({})",
        ScientificText(diagnosis.noise->size, 1), NoiseText(*diagnosis.noise));
    return diagnosis;
  }
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.text = "no classic mistake explains the candidate";
  if (diagnosis.noise)
    diagnosis.text += fmt::format("; {}", NoiseText(*diagnosis.noise));
  return diagnosis;
}

}  // namespace truelux
