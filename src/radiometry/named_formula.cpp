// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/named_formula.h"

#include <cassert>
#include <limits>

#include "radiometry/formula_evaluation.h"
#include "radiometry/stages/channel_sums.h"

namespace truelux {
namespace {

using B = Ball<double>;

/// What kAuto chooses from.
constexpr std::array kCandidates = {Formula::kLambertEdge, Formula::kDifference,
                                    Formula::kSeries, Formula::kCubature};

B WholeBound(const PartialSum<B>& sum) {
  if (!sum.applicable) {
    return {std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::infinity()};
  }
  return Widened(sum.value, sum.truncation);
}

B BestOf(const FormulaEvaluation<B>& formulas, std::size_t i) {
  B best = Unbounded<double>();
  for (const Formula formula : kCandidates) {
    const B sum = WholeBound(formulas.Evaluate(formula, i));
    if (sum.error < best.error) best = sum;
  }
  return best;
}

}  // namespace

std::array<Ball<double>, 3> EvaluateByFormula(
    const WeightedContour& contour, const EvaluationQuery& evaluation) {
  assert(!contour.contour.is_joined);
  const bool is_auto = evaluation.formula == Formula::kAuto;
  FormulaEvaluation<B> formulas(contour, evaluation.half_side);
  // What the series needs serves all candidates.
  formulas.Prepare(is_auto ? Formula::kSeries : evaluation.formula);
  ChannelSums<double> sums(contour);
  for (std::size_t i = 0; i < formulas.lit().size(); ++i) {
    sums.Add(formulas.lit()[i],
             is_auto ? BestOf(formulas, i)
                     : WholeBound(formulas.Evaluate(evaluation.formula, i)));
  }
  return sums.Finish(evaluation.emission == Emission::kRadiance ? Pi(B(0.0))
                                                                : B(1.0));
}

}  // namespace truelux
