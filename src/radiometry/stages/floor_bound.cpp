// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/floor_bound.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radiometry/stages/multiprecision_answer.h"
#include "radiometry/stages/multiprecision_stage.h"

namespace truelux {
namespace {

/// Larger bounds, in units of the channel's largest emission, are made of
/// roundings.
constexpr double kFloor = 0x1p-440;

/// Bounds that are smaller, relative to their values, are good enough.
constexpr double kNarrow = 0x1p-40;

constexpr mpfr_prec_t kFirstPrecision = 128;

/// What is not enclosed more narrowly by then is so small that its bound does
/// not matter.
constexpr mpfr_prec_t kLastPrecision = 4096;

/// The channels whose bounds are mostly floor.
Channels AtFloor(const WeightedContour& contour, const Irradiance& result) {
  Channels at_floor{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double largest = 0;
    for (const Rgb& weight : contour.weights) {
      largest = std::max(largest, weight[channel]);
    }
    const double bound = result.bound[channel];
    at_floor[channel] =
        bound <= kFloor * largest && bound > kNarrow * result.value[channel];
  }
  return at_floor;
}

/// |value - E| at most, rounded up.
double LargestDistance(double value, const Enclosure& enclosure) {
  Multiprecision distance(64);
  mpfr_sub_d(distance.get(), enclosure.upper.get(), value, MPFR_RNDU);
  const double above = mpfr_get_d(distance.get(), MPFR_RNDU);
  mpfr_d_sub(distance.get(), value, enclosure.lower.get(), MPFR_RNDU);
  return std::max(above, mpfr_get_d(distance.get(), MPFR_RNDU));
}

}  // namespace

void NarrowFloorBounds(const WeightedContour& contour,
                       const EvaluationQuery& evaluation, Irradiance& result) {
  Channels open = AtFloor(contour, result);
  if (!Any(open)) return;
  EvaluationQuery over_arcs = evaluation;
  over_arcs.formula = Formula::kAuto;
  const MultiprecisionStage stage(contour, over_arcs, HorizonPlanes());
  for (mpfr_prec_t p = kFirstPrecision; Any(open) && p <= kLastPrecision;
       p *= 2) {
    const std::array<Enclosure, 3> enclosures = stage.Evaluate(p);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (!open[channel]) continue;
      const double value = result.value[channel];
      double& bound = result.bound[channel];
      bound = std::min(bound, LargestDistance(value, enclosures[channel]));
      open[channel] = bound > kNarrow * value;
    }
  }
}

}  // namespace truelux
