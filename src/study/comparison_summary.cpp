// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/comparison_summary.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "text/quantile.h"

namespace truelux {
namespace {

void Count(const ValueError& error, ErrorHistogram& histogram) {
  if (error.exact) {
    ++histogram.exact;
  } else if (error.relative.value_or(0) > 0) {
    ++histogram.decades[DecadeOf(*error.relative)];
  } else {
    ++histogram.false_light;
  }
}

}  // namespace

std::size_t ErrorHistogram::HighestDecade() const {
  return *std::ranges::max_element(decades);
}

std::size_t DecadeOf(double relative_error) {
  constexpr int kLast = static_cast<int>(ErrorHistogram::kDecades) - 1;
  if (!(relative_error < 1)) return kLast;
  const double exponent = std::floor(std::log10(relative_error));
  const double index = exponent - ErrorHistogram::kLowest;
  return static_cast<std::size_t>(
      std::clamp(index, 0.0, static_cast<double>(kLast - 1)));
}

MethodSummary Summarize(const Comparison& comparison,
                        const MethodResult& method) {
  assert(method.values.size() == comparison.receivers.size());
  assert(comparison.truth.size() == comparison.receivers.size());
  MethodSummary summary;
  std::vector<double> errors;
  for (std::size_t i = 0; i < comparison.receivers.size(); ++i) {
    const std::optional<Rgb>& value = method.values[i];
    if (!value) {
      ++summary.histogram.no_value;
      continue;
    }
    ++summary.answered;
    const ValueError error = ErrorOf(*value, comparison.truth[i]);
    if (error.exact) ++summary.exact;
    if (error.false_light) ++summary.false_light;
    if (error.relative) errors.push_back(*error.relative);
    summary.max_absolute = std::max(summary.max_absolute, error.absolute);
    Count(error, summary.histogram);
  }
  summary.lit = errors.size();
  if (!errors.empty()) {
    constexpr double kShare = 0.95;
    summary.relative = {Median(errors), Quantile(errors, kShare),
                        *std::ranges::max_element(errors),
                        RootMeanSquare(errors)};
  }
  return summary;
}

std::vector<MethodSummary> SummarizeAll(const Comparison& comparison) {
  std::vector<MethodSummary> summaries;
  for (const MethodResult& method : comparison.methods)
    summaries.push_back(Summarize(comparison, method));
  return summaries;
}

std::vector<std::size_t> ParetoFront(std::span<const CostAndError> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (points[a].cost != points[b].cost)
      return points[a].cost < points[b].cost;
    return points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || points[i].error < points[front.back()].error)
      front.push_back(i);
  }
  return front;
}

std::vector<std::string> GroupsOf(const Comparison& comparison) {
  std::vector<std::string> groups;
  for (const MethodResult& method : comparison.methods) {
    if (std::ranges::find(groups, method.group) == groups.end())
      groups.push_back(method.group);
  }
  return groups;
}

std::size_t SeriesOf(const MethodResult& method,
                     std::span<const std::string> groups) {
  return static_cast<std::size_t>(std::ranges::find(groups, method.group) -
                                  groups.begin());
}

}  // namespace truelux
