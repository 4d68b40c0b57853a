// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/vector_math.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

/// A factor with a meaning.
struct NamedFactor {
  double factor = 1;
  std::string_view unit;  ///< of a unit of length: what would make it
};

/// Gradients are per unit of length: per metre they are 1000 times as large as
/// per millimetre.
constexpr std::array<NamedFactor, 10> kLengthFactors = {
    {{1000, "per metre, with a scene in millimetres"},
     {1e-3, "per millimetre, with a scene in metres"},
     {100, "per metre, with a scene in centimetres"},
     {1e-2, "per centimetre, with a scene in metres"},
     {10, "per centimetre, with a scene in millimetres"},
     {0.1, "per millimetre, with a scene in centimetres"},
     {1 / 0.0254, "per metre, with a scene in inches"},
     {0.0254, "per inch, with a scene in metres"},
     {1 / 0.3048, "per metre, with a scene in feet"},
     {0.3048, "per foot, with a scene in metres"}}};

/// The factor of a trial, if it differs from 1 by more than noise explains.
std::optional<FactorFit> FactorOf(const GradientTrial& trial) {
  constexpr double kSignificant = 5;
  const std::optional<FactorFit> fit = FitFactor(trial.data());
  if (!fit || std::abs(fit->factor - 1) <=
                  kSignificant * fit->standard_error * std::abs(fit->factor))
    return std::nullopt;
  return fit;
}

/// Whether a fitted factor is meant as a named one: it is nearer than a
/// thousandth, or than noise allows to tell.
bool IsMeantAs(const FactorFit& fit, double named) {
  constexpr double kPossible = 3;
  constexpr double kMeantAs = 1e-3;
  return std::abs(fit.factor / named - 1) <=
         std::max(kPossible * fit.standard_error, kMeantAs);
}

/// The named factor of a unit of length, with either sign.
const NamedFactor* LengthFactorOf(const FactorFit& fit) {
  for (const NamedFactor& named : kLengthFactors) {
    if (IsMeantAs(fit, named.factor) || IsMeantAs(fit, -named.factor))
      return &named;
  }
  return nullptr;
}

/// The factor by which the other --emission would explain the candidate.
double EmissionFactor(const GradientTrial& trial) {
  return trial.oracle().options().emission == Emission::kExitance ? kPi
                                                                  : 1 / kPi;
}

std::vector<GradientHypothesis> ByFactor(const GradientTrial& trial,
                                         const FactorFit& fit,
                                         std::string sentence) {
  GradientHypothesis hypothesis;
  hypothesis.sentence = std::move(sentence);
  hypothesis.factor = fit.factor;
  for (const GradientTruth& truth : trial.data().truth) {
    GradientRow row{};
    for (std::size_t c = 0; c < row.size(); ++c)
      row[c] = Times(fit.factor, truth.gradient[c]);
    hypothesis.predicted.push_back(row);
  }
  return {std::move(hypothesis)};
}

std::vector<GradientHypothesis> AllZero(GradientTrial& trial) {
  const auto is_zero = [](const GradientRow& row) {
    return std::ranges::all_of(
        row, [](const Vector3& g) { return g.x == 0 && g.y == 0 && g.z == 0; });
  };
  if (!std::ranges::all_of(trial.data().values, is_zero)) return {};
  return {{.sentence = "all of the candidate's gradients are 0",
           .predicted = trial.data().values}};
}

std::vector<GradientHypothesis> WrongSign(GradientTrial& trial) {
  const auto fit = FactorOf(trial);
  if (!fit || !IsMeantAs(*fit, -1)) return {};
  return ByFactor(trial, *fit,
                  "the candidate's gradients have the opposite sign: they are "
                  "those of a scene that moves, while the receiver stays");
}

std::vector<GradientHypothesis> UnitOfLength(GradientTrial& trial) {
  const auto fit = FactorOf(trial);
  if (!fit) return {};
  const NamedFactor* named = LengthFactorOf(*fit);
  if (named == nullptr) return {};
  return ByFactor(
      trial, *fit,
      fmt::format("the candidate's gradients are {:.6g} times those of "
                  "truelux; perhaps they are {}{}",
                  fit->factor, named->unit,
                  fit->factor < 0 ? ", and have the opposite sign" : ""));
}

std::vector<GradientHypothesis> ExitanceAgainstRadiance(GradientTrial& trial) {
  const auto fit = FactorOf(trial);
  const double factor = EmissionFactor(trial);
  if (!fit || !IsMeantAs(*fit, factor)) return {};
  return ByFactor(
      trial, *fit,
      factor > 1
          ? fmt::format("factor pi ({:.6g}): Ke was probably read as radiance "
                        "L, M = pi Ke; --emission radiance would agree",
                        fit->factor)
          : fmt::format("factor 1/pi ({:.6g}): Ke was probably read as radiant "
                        "exitance M; --emission exitance would agree",
                        fit->factor));
}

std::vector<GradientHypothesis> ConstantFactor(GradientTrial& trial) {
  const auto fit = FactorOf(trial);
  // Few receivers agree on a factor by chance.
  constexpr std::size_t kFewest = 5;
  if (!fit || trial.data().values.size() < kFewest || IsMeantAs(*fit, -1) ||
      LengthFactorOf(*fit) != nullptr ||
      IsMeantAs(*fit, EmissionFactor(trial))) {
    return {};
  }
  return ByFactor(trial, *fit,
                  fmt::format("the candidate's gradients are {:.9g} times "
                              "those of truelux",
                              fit->factor));
}

std::vector<GradientHypothesis> FlippedNormal(GradientTrial& trial) {
  std::vector<Receiver> flipped = trial.data().receivers;
  for (Receiver& receiver : flipped)
    receiver.normal = Times(-1, receiver.normal);
  return {{.sentence = "the candidate's gradients are those of the receivers' "
                       "reversed normals",
           .predicted = trial.GradientsAt(flipped)}};
}

std::vector<GradientHypothesis> TangentialPart(GradientTrial& trial) {
  GradientHypothesis hypothesis{
      .sentence =
          "the candidate's gradients lack the part along the normal: "
          "they are what truelux gradient --of tangential gives",
      .predicted = {}};
  for (std::size_t i = 0; i < trial.data().truth.size(); ++i) {
    const Vector3 n = UnitOf(trial.data().receivers[i].normal);
    GradientRow row = trial.data().truth[i].gradient;
    for (Vector3& g : row)
      g = Difference(g, Times(Dot(g, n), n));
    hypothesis.predicted.push_back(row);
  }
  return {std::move(hypothesis)};
}

/// The compared channels of rows that have all.
std::vector<GradientRow> Compared(const GradientTrial& trial,
                                  std::span<const GradientRow> rows) {
  std::vector<GradientRow> compared(rows.size());
  const std::vector<std::size_t>& channels = trial.data().channels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < channels.size(); ++c)
      compared[i][c] = rows[i][channels[c]];
  }
  return compared;
}

std::vector<GradientHypothesis> NoShadows(GradientTrial& trial) {
  const auto& sums = trial.Alone();
  if (!sums) return {};
  return {{.sentence = "the candidate's gradients are those of the unshadowed "
                       "irradiance: every source is seen as if nothing else "
                       "were there",
           .predicted = Compared(trial, sums->gradients)}};
}

std::vector<GradientHypothesis> ConstantVisibility(GradientTrial& trial) {
  std::vector<GradientHypothesis> hypotheses;
  if (const auto& sums = trial.Alone()) {
    constexpr const char* kShare =
        "the candidate takes visibility as constant: it multiplies the "
        "gradient of the unshadowed irradiance by the visible share";
    hypotheses.push_back({.sentence = std::string(kShare) + " of each source",
                          .predicted = Compared(trial, sums->by_shares)});
    if (EmittersOf(trial.scene()).size() > 1) {
      hypotheses.push_back({.sentence = std::string(kShare) + " of the light",
                            .predicted = Compared(trial, sums->by_share)});
    }
  }
  if (const auto& fixed = trial.Fixed()) {
    hypotheses.push_back(
        {.sentence = "the candidate takes visibility as constant in every "
                     "direction: edges of blockers do not move, only those of "
                     "sources do",
         .predicted = Compared(trial, fixed->own_edges_only)});
  }
  return hypotheses;
}

std::vector<GradientHypothesis> SourceDepth(GradientTrial& trial) {
  const auto& fixed = trial.Fixed();
  if (!fixed) {
    trial.notes.emplace_back(
        "source's depth for a blocker's edge: not tried with sources that are "
        "not planar");
    return {};
  }
  return {{.sentence =
               "the candidate takes the source's distance for that of a "
               "blocker's edge: shadows move as if they were painted on the "
               "source, which is to take the visibility of its points as "
               "constant",
           .predicted = Compared(trial, fixed->at_source_depth)}};
}

constexpr std::array<GradientMistake, 10> kMistakes = {
    {{"no gradient", AllZero},
     {"wrong sign", WrongSign},
     {"unit of length", UnitOfLength},
     {"exitance against radiance", ExitanceAgainstRadiance},
     {"constant factor", ConstantFactor},
     {"tangential part", TangentialPart},
     {"flipped normal", FlippedNormal},
     {"source's depth for a blocker's edge", SourceDepth},
     {"constant visibility", ConstantVisibility},
     {"no shadows", NoShadows}}};

}  // namespace

std::span<const GradientMistake> GradientMistakes() {
  return kMistakes;
}

}  // namespace truelux
