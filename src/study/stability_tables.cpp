// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/stability_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>

#include "text/quantile.h"

namespace truelux {
namespace {

/// One significant digit: "5e-16".
std::string OneDigit(double x) {
  return x == 0 ? "0" : fmt::format("{:.0e}", x);
}

std::string CellText(const StabilityCell& cell) {
  if (cell.errors.empty()) return "-";
  std::string text = fmt::format("{} / {}", OneDigit(Median(cell.errors)),
                                 OneDigit(Largest(cell.errors)));
  if (cell.not_applicable > 0) {
    text += fmt::format(" ({})", cell.errors.size());
  }
  return text;
}

/// 0 of nothing.
template <class Number>
double MedianOf(const std::vector<Number>& values) {
  return values.empty() ? 0 : Median({values.begin(), values.end()});
}

std::string Row(const std::vector<std::string>& fields) {
  return fmt::format("| {} |\n", fmt::join(fields, " | "));
}

std::string Header(const std::vector<std::string>& fields) {
  std::string text = Row(fields) + "|";
  for (std::size_t i = 0; i < fields.size(); ++i)
    text += "---|";
  return text + "\n";
}

/// Whether a formula was measured in an arithmetic at all.
bool IsMeasured(const std::vector<RegimeStability>& results,
                StudyArithmetic arithmetic, Formula formula) {
  return std::ranges::any_of(results, [&](const RegimeStability& result) {
    const StabilityCell& cell = result.At(arithmetic, formula);
    return !cell.errors.empty() || cell.not_applicable > 0;
  });
}

std::string Explanation(StudyArithmetic arithmetic,
                        const StabilityOptions& options) {
  switch (arithmetic) {
    case StudyArithmetic::kFloat:
    case StudyArithmetic::kDouble:
      return "Relative error, median / largest.";
    case StudyArithmetic::kBounded:
      return "Proven bound of --method double, relative to the true value, "
             "median / largest.";
    case StudyArithmetic::kDoubleDouble:
      return "Relative error of the sum rounded to double, median / largest.";
    case StudyArithmetic::kMpfr128:
      return fmt::format(
          "Relative error of the sum rounded to double, median / largest, the "
          "first {} cases.",
          std::min(options.slow_cases, options.cases));
  }
  return "";
}

std::string ErrorTable(StudyArithmetic arithmetic,
                       const StabilityOptions& options,
                       const std::vector<RegimeStability>& results) {
  std::vector<Formula> formulas;
  std::vector<std::string> names = {"regime", "sources, arcs"};
  for (const Formula formula : AllFormulas()) {
    if (!IsMeasured(results, arithmetic, formula)) continue;
    formulas.push_back(formula);
    names.emplace_back(Name(formula));
  }
  std::string text = fmt::format("\n## {}\n\n{}\n\n", Name(arithmetic),
                                 Explanation(arithmetic, options));
  text += Header(names);
  for (const RegimeStability& result : results) {
    std::vector<std::string> fields = {
        result.regime, fmt::format("{:g}, {:g}", MedianOf(result.sources),
                                   MedianOf(result.arcs))};
    for (const Formula formula : formulas) {
      fields.push_back(CellText(result.At(arithmetic, formula)));
    }
    text += Row(fields);
  }
  return text;
}

/// Median time over all regimes [ns]; 0 if it was not measured.
double TimeOver(const std::vector<RegimeStability>& results,
                StudyArithmetic arithmetic, Formula formula) {
  std::vector<double> times;
  for (const RegimeStability& result : results) {
    const auto& own = result.At(arithmetic, formula).nanoseconds;
    times.insert(times.end(), own.begin(), own.end());
  }
  return MedianOf(times);
}

std::string TimeTable(const StabilityOptions& options,
                      const std::vector<RegimeStability>& results) {
  std::vector<std::string> names = {"formula"};
  for (const StudyArithmetic arithmetic : options.arithmetics) {
    names.emplace_back(Name(arithmetic));
  }
  std::string text =
      "\n## Time\n\nProcessor time of one evaluation [ns], the sum only, "
      "median "
      "over all regimes; in parentheses\nas a multiple of lambert-edge in "
      "double.\n\n";
  text += Header(names);
  const double unit =
      TimeOver(results, StudyArithmetic::kDouble, Formula::kLambertEdge);
  for (const Formula formula : AllFormulas()) {
    if (formula == Formula::kAuto) continue;
    std::vector<std::string> fields = {std::string(Name(formula))};
    for (const StudyArithmetic arithmetic : options.arithmetics) {
      const double time = TimeOver(results, arithmetic, formula);
      fields.push_back(time == 0 ? "-"
                       : unit == 0
                           ? fmt::format("{:.0f}", time)
                           : fmt::format("{:.0f} ({:.2g})", time, time / unit));
    }
    text += Row(fields);
  }
  return text;
}

std::string BoundsText(const std::vector<RegimeStability>& results) {
  std::int64_t checked = 0;
  std::size_t violated = 0;
  std::string list;
  for (const RegimeStability& result : results) {
    checked += result.bounds_checked;
    violated += result.violations.size();
    for (const BoundViolation& v : result.violations) {
      list += fmt::format("- {} case {} {}: {:a} +- {:a}, but {:a}\n", v.regime,
                          v.index, Name(v.formula), v.value, v.bound, v.truth);
    }
  }
  std::string text = fmt::format(
      "\n## Bounds\n\nBounds checked: {}, violations: {}\n", checked, violated);
  if (!list.empty()) text += "\n" + list;
  return text;
}

}  // namespace

std::string StabilityMarkdown(const StabilityOptions& options,
                              const std::vector<RegimeStability>& results) {
  std::int64_t dark = 0;
  for (const RegimeStability& result : results)
    dark += result.dark;
  std::string text = fmt::format(
      "# Stability\n\n{} regimes of {} cases, seed {}. Truth: lambert-edge in "
      "400 bits. -: the formula does not apply; (n): it\napplies to n cases. "
      "Cases of which nothing is visible, left out: {}.\n",
      results.size(), options.cases, options.seed, dark);
  for (const StudyArithmetic arithmetic : options.arithmetics) {
    text += ErrorTable(arithmetic, options, results);
  }
  return text + TimeTable(options, results) + BoundsText(results);
}

std::string StabilityCsv(const std::vector<RegimeStability>& results) {
  std::string text =
      "regime,occluded,arithmetic,formula,cases,not_applicable,median,max,"
      "median_ns,median_sources,median_arcs\n";
  for (const RegimeStability& result : results) {
    for (const StudyArithmetic arithmetic : kArithmetics) {
      for (const Formula formula : AllFormulas()) {
        const StabilityCell& cell = result.At(arithmetic, formula);
        if (cell.errors.empty()) continue;
        fmt::format_to(std::back_inserter(text),
                       "{},{},{},{},{},{},{},{},{:.1f},{},{}\n", result.regime,
                       result.occluded ? 1 : 0, Name(arithmetic), Name(formula),
                       cell.errors.size(), cell.not_applicable,
                       Median(cell.errors), Largest(cell.errors),
                       MedianOf(cell.nanoseconds), MedianOf(result.sources),
                       MedianOf(result.arcs));
      }
    }
  }
  return text;
}

}  // namespace truelux
