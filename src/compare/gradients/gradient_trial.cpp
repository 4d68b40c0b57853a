// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_trial.h"

#include <cstddef>
#include <limits>

#include "scene/scene_variants.h"

namespace truelux {
namespace {

GradientRow Unknown() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  GradientRow row;
  row.fill({kNan, kNan, kNan});
  return row;
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

}  // namespace truelux
