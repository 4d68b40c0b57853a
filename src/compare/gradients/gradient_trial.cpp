// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_trial.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "base/vector_math.h"
#include "scene/emitters.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

GradientRow Unknown() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  GradientRow row;
  row.fill({kNan, kNan, kNan});
  return row;
}

/// The form factor of a face (index): a table has those that emit, also ones
/// without area.
double FactorOf(const FormFactorTable& table, int face) {
  return std::ranges::find(table.faces, face + 1, &FaceFormFactor::face)->value;
}

}  // namespace

GradientTrial::GradientTrial(const Oracle& oracle, const GradientData& data,
                             const GradientEvaluators& evaluate)
    : oracle_(oracle),
      data_(data),
      evaluate_(evaluate),
      receivers_without_(oracle.scene()) {}

std::vector<GradientRow> GradientTrial::GradientsOf(
    std::span<const Derivatives> derivatives) const {
  std::vector<GradientRow> rows;
  rows.reserve(derivatives.size());
  for (const Derivatives& d : derivatives) {
    rows.push_back(d.smoothness == Smoothness::kDiscontinuous
                       ? Unknown()
                       : ComparedGradients(data_, d));
  }
  return rows;
}

std::vector<GradientRow> GradientTrial::GradientsAt(
    std::span<const Receiver> receivers) const {
  return GradientsOf(evaluate_.derivatives(scene(), receivers));
}

std::vector<Derivatives> GradientTrial::WithFaceAlone(int face) {
  std::vector<int> others;
  for (int other = 0; other < static_cast<int>(scene().faces().size());
       ++other) {
    if (other != face) others.push_back(other);
  }
  return evaluate_.derivatives(WithoutFaces(scene(), others),
                               receivers_without_.Of(data_.receivers, others));
}

const std::optional<AloneSums>& GradientTrial::Alone() {
  if (!alone_) alone_ = FindAloneSums();
  return *alone_;
}

const std::optional<FixedVisibility>& GradientTrial::Fixed() {
  if (!fixed_) fixed_ = FixedVisibilityOf(oracle_, data_.receivers);
  return *fixed_;
}

std::optional<AloneSums> GradientTrial::FindAloneSums() {
  constexpr std::size_t kMostSources = 64;
  constexpr std::size_t kMostWork = 5'000'000;
  const Scene& scene = oracle_.scene();
  const std::vector<int> emitters = EmittersOf(scene);
  if (emitters.size() > kMostSources ||
      emitters.size() * scene.faces().size() > kMostWork) {
    notes.push_back(
        fmt::format("no shadows, constant visibility: not tried with {} "
                    "sources among {} faces",
                    emitters.size(), scene.faces().size()));
    return std::nullopt;
  }
  const std::vector<Receiver>& receivers = data_.receivers;
  const double scale =
      oracle_.options().emission == Emission::kRadiance ? std::numbers::pi : 1;
  std::vector<FormFactorTable> factors;
  factors.reserve(receivers.size());
  for (const Receiver& receiver : receivers)
    factors.push_back(oracle_.FormFactors(receiver));
  const std::size_t count = receivers.size();
  AloneSums sums{std::vector<GradientRow>(count),
                 std::vector<GradientRow>(count),
                 std::vector<GradientRow>(count)};
  std::vector<Rgb> visible(count);
  std::vector<Rgb> alone(count);
  for (std::size_t s = 0; s < emitters.size(); ++s) {
    const Face& face = scene.faces()[static_cast<std::size_t>(emitters[s])];
    const std::vector<Derivatives> derivatives = WithFaceAlone(emitters[s]);
    for (std::size_t i = 0; i < count; ++i) {
      const Derivatives& d = derivatives[i];
      if (d.smoothness == Smoothness::kDiscontinuous) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double lit =
            FactorOf(factors[i], emitters[s]) * face.emission[c] * scale;
        const double all = d.irradiance.value[c];
        const Vector3& g = d.channels[c].gradient;
        visible[i][c] += lit;
        alone[i][c] += all;
        sums.gradients[i][c] = Sum(sums.gradients[i][c], g);
        sums.by_shares[i][c] =
            Sum(sums.by_shares[i][c], Times(all > 0 ? lit / all : 0, g));
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double share = alone[i][c] > 0 ? visible[i][c] / alone[i][c] : 0;
      sums.by_share[i][c] = Times(share, sums.gradients[i][c]);
    }
  }
  return sums;
}

}  // namespace truelux
