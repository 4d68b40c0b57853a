// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance by a formula at any number type, without a bound.

#ifndef TRUELUX_RADIOMETRY_FORMULA_SUM_H_
#define TRUELUX_RADIOMETRY_FORMULA_SUM_H_

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>

#include "truelux/geometry.h"

#include "radiometry/formula_evaluation.h"

namespace truelux {

/// The sum over the lit sources of weight times form factor, per channel, in T
/// and then rounded to binary64; nothing if the formula does not apply to one
/// of them. weights: one entry for each source of the contour. Requires
/// formulas.Prepare(formula).
template <class T>
std::optional<Rgb> SumByFormula(const FormulaEvaluation<T>& formulas,
                                Formula formula, std::span<const Rgb> weights) {
  std::array<T, 3> value = {Make<T>(0), Make<T>(0), Make<T>(0)};
  for (std::size_t i = 0; i < formulas.lit().size(); ++i) {
    const PartialSum<T> sum = formulas.Evaluate(formula, i);
    if (!sum.applicable) return std::nullopt;
    assert(formulas.lit()[i].index() < weights.size());
    const Rgb& weight = weights[formulas.lit()[i].index()];
    for (std::size_t channel = 0; channel < 3; ++channel)
      value[channel] = value[channel] + Make<T>(weight[channel]) * sum.value;
  }
  return Rgb{Leading(value[0]), Leading(value[1]), Leading(value[2])};
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULA_SUM_H_
