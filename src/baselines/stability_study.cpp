// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/stability_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "baselines/case_contour.h"
#include "baselines/timing.h"
#include "radiometry/evaluate_weighted.h"
#include "radiometry/formula_evaluation.h"
#include "radiometry/weighted_contour.h"

namespace truelux {
namespace {

using B = Ball<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Cancellation costs the hardest regimes less than 120 bits.
constexpr mpfr_prec_t kTruthBits = 400;

/// The plane of the image, as good as whole: no case reaches the horizon, and
/// the lowest points are 1e-12 above it.
constexpr double kWholePlane = 0x1p60;

static_assert(static_cast<std::size_t>(Formula::kCubature) + 1 ==
              kFormulaCount);

/// What an arithmetic is called by its number type.
template <class T>
constexpr StudyArithmetic ArithmeticOf() {
  if constexpr (std::is_same_v<T, float>) return StudyArithmetic::kFloat;
  if constexpr (std::is_same_v<T, double>) return StudyArithmetic::kDouble;
  if constexpr (kIsBall<T>) return StudyArithmetic::kBounded;
  if constexpr (std::is_same_v<T, DoubleDouble>) {
    return StudyArithmetic::kDoubleDouble;
  }
  return StudyArithmetic::kMpfr128;
}

/// The sum over the lit sources of a contour.
template <class T>
PartialSum<T> SumOverSources(const FormulaEvaluation<T>& formulas,
                             Formula formula) {
  PartialSum<T> sum{Make<T>(0)};
  for (std::size_t i = 0; i < formulas.lit().size(); ++i) {
    const PartialSum<T> part = formulas.Evaluate(formula, i);
    sum.applicable = sum.applicable && part.applicable;
    sum.value = i == 0 ? part.value : sum.value + part.value;
    sum.truncation += part.truncation;
  }
  return sum;
}

/// Processor time of one call [ns], of as many as the clock needs.
template <class Function>
double TimeOf(const Function& call) {
  constexpr double kEnough = 20e-6;
  for (int repeats = 1;; repeats *= 2) {
    const double start = ThreadSeconds();
    for (int i = 0; i < repeats; ++i)
      call();
    const double elapsed = ThreadSeconds() - start;
    if (elapsed >= kEnough) return 1e9 * elapsed / repeats;
  }
}

/// Measures the cases of a regime, one after the other.
class Study {
 public:
  Study(const Regime& regime, const StabilityOptions& options)
      : regime_(regime), options_(options) {
    result_.regime = regime.name;
    result_.occluded = regime.occluded;
    result_.cases = options.cases;
  }

  void Add(int index) {
    index_ = index;
    const CaseContour made(
        regime_.Make(options_.seed, static_cast<std::uint64_t>(index)));
    const WeightedContour contour = made.Weighted();
    FormulaEvaluation<Multiprecision> exact(contour, kWholePlane, kTruthBits);
    exact.Prepare(Formula::kLambertEdge);
    truth_ = SumOverSources(exact, Formula::kLambertEdge).value;
    if (IsZero(truth_)) {
      ++result_.dark;
      return;
    }
    result_.sources.push_back(static_cast<int>(exact.lit().size()));
    result_.arcs.push_back(static_cast<int>(contour.contour.arcs.size()));
    for (const StudyArithmetic arithmetic : options_.arithmetics)
      Measure(arithmetic, contour);
  }

  RegimeStability Take() { return std::move(result_); }

 private:
  void Measure(StudyArithmetic arithmetic, const WeightedContour& contour) {
    switch (arithmetic) {
      case StudyArithmetic::kFloat:
        return MeasureAll<float>(contour);
      case StudyArithmetic::kDouble:
        return MeasureAll<double>(contour);
      case StudyArithmetic::kBounded:
        MeasureAll<B>(contour);
        return MeasureAuto(contour);
      case StudyArithmetic::kDoubleDouble:
        return MeasureAll<DoubleDouble>(contour);
      case StudyArithmetic::kMpfr128:
        if (index_ < options_.slow_cases) MeasureAll<Multiprecision>(contour);
        return;
    }
  }

  template <class T>
  void MeasureAll(const WeightedContour& contour) {
    // A bound is that of --method double, with the square that it has there.
    FormulaEvaluation<T> formulas(
        contour, kIsBall<T> ? EvaluationQuery{}.half_side : kWholePlane, 128);
    for (const Formula formula : AllFormulas()) {
      if (formula == Formula::kAuto) continue;
      formulas.Prepare(formula);
      const PartialSum<T> sum = SumOverSources(formulas, formula);
      StabilityCell& cell = result_.At(ArithmeticOf<T>(), formula);
      if (!sum.applicable) {
        ++cell.not_applicable;
        continue;
      }
      if constexpr (kIsBall<T>) {
        AddBound(Widened(sum.value, sum.truncation), formula);
      } else {
        cell.errors.push_back(RelativeError(ToDouble(sum.value)));
      }
      if (index_ >= options_.timed_cases) continue;
      cell.nanoseconds.push_back(
          TimeOf([&] { SumOverSources(formulas, formula); }));
    }
  }

  void MeasureAuto(const WeightedContour& contour) {
    EvaluationQuery query;
    query.method = Method::kDouble;
    const Irradiance answer = EvaluateWeighted(contour, query);
    AddBound({answer.value[0], answer.bound[0]}, Formula::kAuto);
    result_.At(StudyArithmetic::kDouble, Formula::kAuto)
        .errors.push_back(RelativeError(answer.value[0]));
  }

  static double ToDouble(const Multiprecision& x) { return x.ToDouble(); }

  template <class T>
  static double ToDouble(const T& x) {
    return Leading(x);
  }

  /// |value - truth|.
  [[nodiscard]] Multiprecision Error(double value) const {
    Multiprecision error(kTruthBits);
    mpfr_sub_d(error.get(), truth_.get(), value, MPFR_RNDN);
    mpfr_abs(error.get(), error.get(), MPFR_RNDN);
    return error;
  }

  [[nodiscard]] double RelativeError(double value) const {
    if (!std::isfinite(value)) return kInfinity;
    return (Error(value) / truth_).ToDouble();
  }

  void AddBound(const B& ball, Formula formula) {
    const bool bounded = std::isfinite(ball.error);
    const double bound = bounded ? ball.error : kInfinity;
    result_.At(StudyArithmetic::kBounded, formula)
        .errors.push_back(bound / truth_.ToDouble());
    ++result_.bounds_checked;
    // A number without a bound promises nothing.
    if (!bounded) return;
    if (std::isfinite(ball.value) &&
        mpfr_cmp_d(Error(ball.value).get(), bound) <= 0) {
      return;
    }
    result_.violations.push_back({regime_.name,
                                  static_cast<std::uint64_t>(index_), formula,
                                  ball.value, bound, truth_.ToDouble()});
  }

  const Regime& regime_;
  const StabilityOptions& options_;
  int index_ = 0;  ///< of the case
  Multiprecision truth_;
  RegimeStability result_;
};

}  // namespace

std::string_view Name(StudyArithmetic arithmetic) {
  switch (arithmetic) {
    case StudyArithmetic::kFloat:
      return "float";
    case StudyArithmetic::kDouble:
      return "double";
    case StudyArithmetic::kBounded:
      return "bounded double";
    case StudyArithmetic::kDoubleDouble:
      return "double-double";
    case StudyArithmetic::kMpfr128:
      return "MPFR 128";
  }
  return "";
}

double Largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

RegimeStability MeasureStability(const Regime& regime,
                                 const StabilityOptions& options,
                                 const std::function<void()>& after_case) {
  Study study(regime, options);
  for (int i = 0; i < options.cases; ++i) {
    study.Add(i);
    after_case();
  }
  return study.Take();
}

}  // namespace truelux
