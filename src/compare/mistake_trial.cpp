// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/mistake_trial.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "scene/scene_variants.h"
#include "text/evenly_picked.h"

namespace truelux {
namespace {

Receiver FlippedReceiver(Receiver receiver) {
  const Vector3 n = receiver.normal;
  receiver.normal = {-n.x, -n.y, -n.z};
  return receiver;
}

}  // namespace

MistakeTrial::MistakeTrial(const Scene& scene, const CandidateData& data,
                           const TruthOptions& options,
                           const SceneEvaluator& evaluate)
    : scene_(scene),
      data_(data),
      options_(options),
      evaluate_(evaluate),
      receivers_without_(scene) {
  for (const Receiver& receiver : data.receivers)
    flipped_receivers_.push_back(FlippedReceiver(receiver));
}

std::vector<Rgb> MistakeTrial::Evaluate(
    const Scene& variant, std::span<const Receiver> receivers) const {
  std::vector<Rgb> values = evaluate_(variant, receivers);
  for (Rgb& value : values)
    value = data_.Compared(value);
  return values;
}

std::vector<Rgb> MistakeTrial::ValuesOf(const Scene& variant) const {
  return Evaluate(variant, data_.receivers);
}

std::vector<Rgb> MistakeTrial::FlippedValuesOf(const Scene& variant) const {
  return Evaluate(variant, flipped_receivers_);
}

const std::vector<Rgb>& MistakeTrial::Flipped() {
  if (!flipped_) flipped_ = FlippedValuesOf(scene_);
  return *flipped_;
}

const std::vector<Rgb>& MistakeTrial::Reversed() {
  if (!reversed_) reversed_ = ValuesOf(WithReversedEmitters(scene_));
  return *reversed_;
}

std::vector<Rgb> MistakeTrial::ValuesWithout(std::span<const int> faces) {
  return Evaluate(WithoutFaces(scene_, faces),
                  receivers_without_.Of(data_.receivers, faces));
}

std::optional<std::vector<Rgb>> MistakeTrial::ValuesOnFaces() const {
  const auto receivers = ReceiversOnFaces(scene_, data_.receivers);
  if (!receivers) return std::nullopt;
  return Evaluate(scene_, *receivers);
}

MistakeTrial MistakeTrial::On(const CandidateData& some) const {
  return {scene_, some, options_, evaluate_};
}

CandidateData SomeOf(const CandidateData& data,
                     std::span<const std::size_t> indices) {
  CandidateData some{SomeReceiversOf(data, indices), {}, {}};
  for (const std::size_t i : indices) {
    some.values.push_back(data.values[i]);
    some.truth.push_back(data.truth[i]);
  }
  return some;
}

std::vector<std::size_t> TrialReceivers(std::span<const CandidateError> errors,
                                        std::size_t most) {
  std::vector<std::size_t> failing;
  std::vector<std::size_t> passing;
  for (std::size_t i = 0; i < errors.size(); ++i)
    (errors[i].passes ? passing : failing).push_back(i);
  const std::size_t half = most / 2;
  const std::size_t few_passing = std::min(passing.size(), half);
  const std::size_t few_failing = std::min(failing.size(), most - few_passing);
  std::vector<std::size_t> chosen;
  for (const std::size_t k : EvenlyPicked(failing.size(), few_failing))
    chosen.push_back(failing[k]);
  for (const std::size_t k : EvenlyPicked(passing.size(), most - few_failing))
    chosen.push_back(passing[k]);
  std::ranges::sort(chosen);
  return chosen;
}

std::vector<Rgb> Combined(std::span<const Rgb> a, double factor,
                          std::span<const Rgb> b) {
  std::vector<Rgb> sums(a.begin(), a.end());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (std::size_t c = 0; c < sums[i].size(); ++c)
      sums[i][c] += factor * b[i][c];
  }
  return sums;
}

std::vector<Rgb> Mapped(std::span<const Rgb> values,
                        const std::function<double(double)>& f) {
  std::vector<Rgb> mapped(values.begin(), values.end());
  for (Rgb& value : mapped)
    std::ranges::transform(value, value.begin(), f);
  return mapped;
}

}  // namespace truelux
