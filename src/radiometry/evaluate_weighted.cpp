// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in order: double or double-double with a running bound, then
// Arb with growing precision.

#include "radiometry/evaluate_weighted.h"

#include <cmath>
#include <limits>

#include "exact/ball.h"
#include "radiometry/evaluation_workspace.h"
#include "radiometry/named_formula.h"
#include "radiometry/stages/ball_stage.h"
#include "radiometry/stages/floor_bound.h"
#include "radiometry/stages/multiprecision_answer.h"
#include "radiometry/stages/multiprecision_stage.h"
#include "radiometry/stages/rounding.h"
#include "radiometry/weighted_contour.h"

namespace truelux {
namespace {

Channels LitChannels(const WeightedContour& contour) {
  Channels lit{};
  for (const SourceId source : contour.contour.sources.ids()) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      lit[channel] = lit[channel] || contour.IsLit(source, channel);
    }
  }
  return lit;
}

/// Answers what plain double can bound, clamped to >= 0 as E is.
void TakeBounded(const std::array<Ball<double>, 3>& balls, Channels& open,
                 Irradiance& result) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!open[channel] || !IsBounded(balls[channel])) continue;
    result.value[channel] = ClampToNonNegative(balls[channel]).value;
    result.bound[channel] = balls[channel].error;
    open[channel] = false;
  }
}

/// Larger bounds, relative to their values, are worth another formula.
constexpr double kWideBound = 0x1p-33;

/// Takes those of the other answers that have smaller bounds.
void TakeNarrower(const std::array<Ball<double>, 3>& balls,
                  Irradiance& result) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!(balls[channel].error < result.bound[channel])) continue;
    result.value[channel] = ClampToNonNegative(balls[channel]).value;
    result.bound[channel] = balls[channel].error;
  }
}

/// Answers whatever came out: what a formula cannot bound has no bound, and is
/// no number unless it is too large for binary64.
void TakeAll(const std::array<Ball<double>, 3>& balls, const Channels& lit,
             Irradiance& result) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!lit[channel]) continue;
    const Ball<double>& ball = balls[channel];
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const bool bounded = IsBounded(ball);
    const bool overflows = ball.value == kInfinity && std::isfinite(ball.error);
    result.value[channel] = bounded     ? ClampToNonNegative(ball).value
                            : overflows ? kInfinity
                                        : std::nan("");
    result.bound[channel] = bounded ? ball.error : kInfinity;
    if (overflows) ++result.statistics.overflows;
  }
}

void AnswerInDoubleDouble(const WeightedContour& contour,
                          const EvaluationQuery& evaluation,
                          const HorizonPlanes& on_horizon,
                          BallGeometry<DoubleDouble>& geometry, Channels& open,
                          Irradiance& result) {
  const auto balls = EvaluateInBalls(contour, evaluation, on_horizon, geometry);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!open[channel]) continue;
    const auto value = RoundIfCertain(balls[channel]);
    if (value) AnswerCertified(*value, channel, open, result);
  }
}

}  // namespace

bool HasWideBound(const Irradiance& result) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (result.bound[channel] > kWideBound * result.value[channel]) return true;
  }
  return false;
}

Irradiance EvaluateWeighted(const WeightedContour& contour,
                            const EvaluationQuery& evaluation,
                            EvaluationWorkspace& workspace) {
  Irradiance result;
  Channels open = LitChannels(contour);
  if (!Any(open)) {
    result.statistics.evaluated_zero = 1;
    return result;
  }
  if (evaluation.method == Method::kDouble &&
      evaluation.formula != Formula::kAuto) {
    TakeAll(EvaluateByFormula(contour, evaluation), open, result);
    NarrowFloorBounds(contour, evaluation, result);
    result.statistics.evaluated_double = 1;
    return result;
  }
  const HorizonPlanes on_horizon = SumsOverVertices(evaluation.formula)
                                       ? PlanesOnHorizon(contour)
                                       : HorizonPlanes();
  if (evaluation.method == Method::kDouble) {
    TakeBounded(
        EvaluateInBalls(contour, evaluation, on_horizon, workspace.plain), open,
        result);
    if (!Any(open)) {
      if (!contour.contour.is_joined && HasWideBound(result)) {
        TakeNarrower(EvaluateByFormula(contour, evaluation), result);
        NarrowFloorBounds(contour, evaluation, result);
      }
      result.statistics.evaluated_double = 1;
      return result;
    }
  }
  AnswerInDoubleDouble(contour, evaluation, on_horizon, workspace.double_double,
                       open, result);
  if (!Any(open)) {
    result.statistics.evaluated_double_double = 1;
    return result;
  }
  AnswerInMultiprecision(MultiprecisionStage(contour, evaluation, on_horizon),
                         open, result);
  result.statistics.evaluated_multiprecision = 1;
  return result;
}

Irradiance EvaluateWeighted(const WeightedContour& contour,
                            const EvaluationQuery& evaluation) {
  EvaluationWorkspace workspace;
  return EvaluateWeighted(contour, evaluation, workspace);
}

}  // namespace truelux
