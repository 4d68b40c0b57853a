// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/formula_contender.h"

#include <fmt/format.h>
#include <memory>
#include <utility>
#include <vector>

#include "baselines/timing.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluation_query.h"
#include "radiometry/formula_sum.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

constexpr mpfr_prec_t kPrecision = 128;

/// The contours of many receivers, and what each source of them emits.
struct SeenSources {
  ContourQuery query;
  Contour contour;
  std::vector<Rgb> weights;
};

/// What one thread needs.
struct State {
  explicit State(const Scene& scene) : engine(scene), builder(engine) {}

  ContourEngine engine;
  ContourBuilder builder;
};

void FindContours(State& state, std::span<const Receiver> receivers,
                  std::vector<SeenSources>& seen) {
  const Scene& scene = state.engine.scene();
  state.builder.StartBlock(receivers);
  seen.reserve(receivers.size());
  for (const Receiver& receiver : receivers) {
    SeenSources& next = seen.emplace_back();
    next.query = {scene, receiver};
    state.builder.Build(next.query, next.contour);
    FindWeights(next.query, next.contour, next.weights);
  }
}

template <class T>
Contender MakeContender(const Scene& scene, Formula formula) {
  const auto state = std::make_shared<State>(scene);
  const auto not_counted = std::make_shared<double>(0);
  Contender contender;
  contender.not_counted = not_counted;
  contender.run = [=](std::span<const Receiver> receivers) {
    std::vector<SeenSources> seen;
    FindContours(*state, receivers, seen);
    const double start = ThreadSeconds();
    std::vector<std::unique_ptr<FormulaEvaluation<T>>> formulas;
    for (const SeenSources& s : seen) {
      formulas.push_back(std::make_unique<FormulaEvaluation<T>>(
          WeightedContour{ViewOf(s.query), s.contour, s.weights},
          EvaluationQuery{}.half_side, kPrecision));
      formulas.back()->Prepare(formula);
    }
    *not_counted += ThreadSeconds() - start;
    std::vector<std::optional<Irradiance>> results(receivers.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const std::optional<Rgb> value =
          SumByFormula(*formulas[i], formula, seen[i].weights);
      if (value) results[i].emplace().value = *value;
    }
    return results;
  };
  return contender;
}

}  // namespace

Contender FormulaContender(const Scene& scene, Formula formula,
                           Arithmetic arithmetic) {
  Contender contender = [&] {
    switch (arithmetic) {
      case Arithmetic::kFloat:
        return MakeContender<float>(scene, formula);
      case Arithmetic::kDouble:
        return MakeContender<double>(scene, formula);
      case Arithmetic::kDoubleDouble:
        return MakeContender<DoubleDouble>(scene, formula);
      case Arithmetic::kMultiprecision:
        break;
    }
    return MakeContender<Multiprecision>(scene, formula);
  }();
  contender.name = fmt::format("{} {}", Name(formula), Name(arithmetic));
  contender.group = fmt::format("formulas, {}", Name(arithmetic));
  return contender;
}

}  // namespace truelux
