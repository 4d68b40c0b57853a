// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <string>

#include "compare/mistake_fit.h"
#include "scene/emitters.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

/// What a candidate's values are a multiple of the truth by.
struct NamedFactor {
  double factor = 1;
  std::string_view name;  ///< "" if it is none of those that have one
};

constexpr std::array<NamedFactor, 4> kNamedFactors = {
    {{kPi, "pi"}, {1 / kPi, "1/pi"}, {2, "2"}, {0.5, "1/2"}}};

/// The factor of a trial, if it differs from 1 by more than noise explains. A
/// named one if it is nearer than a thousandth (3.14 is meant as pi) or than
/// noise allows to tell.
std::optional<NamedFactor> FactorOf(const MistakeTrial& trial) {
  constexpr double kSignificant = 5;
  constexpr double kPossible = 3;
  constexpr double kMeantAs = 1e-3;
  const std::optional<FactorFit> fit = FitFactor(trial.data());
  if (!fit) return std::nullopt;
  const double error = fit->standard_error;
  if (std::abs(fit->factor - 1) <= kSignificant * error * fit->factor)
    return std::nullopt;
  for (const NamedFactor& named : kNamedFactors) {
    const double difference = std::abs(fit->factor / named.factor - 1);
    if (difference <= kPossible * error + 1e-12) return named;
    if (difference <= kMeantAs) return NamedFactor{fit->factor, named.name};
  }
  return NamedFactor{fit->factor, ""};
}

/// The --emission with which a factor would be explained, if any.
std::optional<Emission> OtherEmission(const NamedFactor& factor,
                                      const TruthOptions& options) {
  if (options.quantity == Quantity::kFormFactor) return std::nullopt;
  const bool is_exitance = options.emission == Emission::kExitance;
  if (factor.name != (is_exitance ? "pi" : "1/pi")) return std::nullopt;
  return is_exitance ? Emission::kRadiance : Emission::kExitance;
}

Hypothesis FactorHypothesis(const MistakeTrial& trial,
                            const NamedFactor& factor, std::string sentence) {
  Hypothesis hypothesis;
  hypothesis.sentence = std::move(sentence);
  hypothesis.factor = factor.factor;
  hypothesis.predicted = Mapped(
      trial.data().truth, [&](double truth) { return factor.factor * truth; });
  return hypothesis;
}

std::vector<Hypothesis> ConstantFactor(MistakeTrial& trial) {
  const auto factor = FactorOf(trial);
  if (!factor || OtherEmission(*factor, trial.options())) return {};
  std::string sentence = fmt::format(
      "the candidate's values are {}{:.6g}{} times those of truelux",
      factor->name.empty() ? "" : fmt::format("{} (", factor->name),
      factor->factor, factor->name.empty() ? "" : ")");
  if (factor->name == "1/pi") {
    sentence +=
        "; perhaps it gives the radiance that a white Lambertian "
        "surface sends back, E / pi";
  }
  return {FactorHypothesis(trial, *factor, std::move(sentence))};
}

std::vector<Hypothesis> ExitanceAgainstRadiance(MistakeTrial& trial) {
  const auto factor = FactorOf(trial);
  if (!factor) return {};
  const auto emission = OtherEmission(*factor, trial.options());
  if (!emission) return {};
  return {FactorHypothesis(
      trial, *factor,
      *emission == Emission::kRadiance
          ? fmt::format("factor pi ({:.6g}): Ke was probably read as radiance "
                        "L, M = pi Ke; --emission radiance would agree",
                        factor->factor)
          : fmt::format("factor 1/pi ({:.6g}): Ke was probably read as radiant "
                        "exitance M; --emission exitance would agree",
                        factor->factor))};
}

std::vector<Hypothesis> FlippedNormal(MistakeTrial& trial) {
  return {{.sentence = "the candidate's values are those of the receivers' "
                       "reversed normals, E at -n",
           .predicted = trial.Flipped()}};
}

std::vector<Hypothesis> TwoSidedEmission(MistakeTrial& trial) {
  return {{.sentence = "the candidate's faces emit from both sides; here a "
                       "face is black from behind",
           .predicted = trial.ValuesOf(WithTwoSidedEmitters(trial.scene()))}};
}

std::vector<Hypothesis> WrongSide(MistakeTrial& trial) {
  return {{.sentence = "the candidate's faces emit from their backs: the "
                       "vertices run clockwise seen from the side that emits",
           .predicted = trial.Reversed()}};
}

/// Per source the signed value over the whole sphere; nothing if that takes
/// too long.
std::vector<std::vector<Rgb>> SignedValuesOfSources(MistakeTrial& trial) {
  constexpr std::size_t kMostSources = 32;
  const std::vector<int> emitters = EmittersOf(trial.scene());
  std::vector<std::vector<Rgb>> values;
  if (emitters.size() < 2) return values;
  if (emitters.size() > kMostSources) {
    trial.notes.push_back(
        fmt::format("no horizon clip of each source by itself: not tried with "
                    "{} sources, only with up to {}",
                    emitters.size(), kMostSources));
    return values;
  }
  for (const int emitter : emitters) {
    const Scene one = WithOneEmitter(trial.scene(), emitter);
    values.push_back(
        Combined(trial.ValuesOf(one), -1, trial.FlippedValuesOf(one)));
  }
  return values;
}

std::vector<Hypothesis> NoHorizonClip(MistakeTrial& trial) {
  constexpr const char* kText =
      "the candidate does not clip at the horizon: what lies below counts "
      "negatively, E(n) - E(-n)";
  const auto positive = [](double e) { return std::max(e, 0.0); };
  const auto size = [](double e) { return std::abs(e); };
  const std::vector<Rgb> whole =
      Combined(trial.data().truth, -1, trial.Flipped());
  std::vector<Hypothesis> hypotheses;
  const auto add = [&](std::string_view more, std::vector<Rgb> predicted) {
    hypotheses.push_back({.sentence = fmt::format("{}{}", kText, more),
                          .predicted = std::move(predicted)});
  };
  add("", whole);
  add(", and 0 where that is negative", Mapped(whole, positive));
  add(", without its sign", Mapped(whole, size));
  const auto sources = SignedValuesOfSources(trial);
  if (sources.empty()) return hypotheses;
  std::vector<Rgb> positives(whole.size());
  std::vector<Rgb> sizes(whole.size());
  for (const std::vector<Rgb>& source : sources) {
    positives = Combined(positives, 1, Mapped(source, positive));
    sizes = Combined(sizes, 1, Mapped(source, size));
  }
  add(", and 0 for every source of which that is negative", positives);
  add(", without its sign for every source", sizes);
  return hypotheses;
}

std::vector<Hypothesis> NoShadows(MistakeTrial& trial) {
  constexpr std::size_t kMostSources = 256;
  constexpr std::size_t kMostWork = 20'000'000;
  const std::vector<int> emitters = EmittersOf(trial.scene());
  const std::size_t face_count = trial.scene().faces().size();
  if (emitters.empty()) return {};
  if (emitters.size() > kMostSources ||
      emitters.size() * face_count > kMostWork) {
    trial.notes.push_back(
        fmt::format("no shadows: not tried with {} sources among {} faces",
                    emitters.size(), face_count));
    return {};
  }
  std::vector<Rgb> sum(trial.data().truth.size());
  for (const int emitter : emitters) {
    std::vector<int> others;
    for (int face = 0; face < static_cast<int>(face_count); ++face) {
      if (face != emitter) others.push_back(face);
    }
    sum = Combined(sum, 1, trial.ValuesWithout(others));
  }
  return {{.sentence = "the candidate has no shadows at all: every source is "
                       "seen as if nothing else were there",
           .predicted = std::move(sum)}};
}

constexpr std::array<Mistake, 8> kMistakes = {
    {{"constant factor", ConstantFactor},
     {"exitance against radiance", ExitanceAgainstRadiance},
     {"flipped normal", FlippedNormal},
     {"two-sided emission", TwoSidedEmission},
     {"emission from the wrong side", WrongSide},
     {"missing horizon clip", NoHorizonClip},
     {"left-out object", LeftOutGroups},
     {"no shadows", NoShadows}}};

}  // namespace

std::span<const Mistake> Mistakes() {
  return kMistakes;
}

}  // namespace truelux
