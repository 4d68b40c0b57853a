// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/report_view.h"

#include <algorithm>
#include <limits>

namespace truelux {

ReportView::ReportView(const Comparison& compared)
    : comparison(compared),
      groups(GroupsOf(compared)),
      summaries(SummarizeAll(compared)) {
  std::vector<std::size_t> candidates;
  std::vector<CostAndError> points;
  for (std::size_t m = 0; m < compared.methods.size(); ++m) {
    const MethodResult& method = compared.methods[m];
    series.push_back(SeriesOf(method, groups));
    if (!summaries[m].AnswersAll(compared)) continue;
    candidates.push_back(m);
    points.push_back({method.microseconds, ErrorInChart(summaries[m])});
  }
  for (const std::size_t i : ParetoFront(points))
    front.push_back(candidates[i]);
}

bool ReportView::IsOnFront(std::size_t method) const {
  return std::ranges::find(front, method) != front.end();
}

std::size_t ReportView::LitReceivers() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(comparison.truth, [](const Rgb& truth) {
        return std::ranges::any_of(truth, [](double e) { return e > 0; });
      }));
}

double ErrorInChart(const MethodSummary& summary) {
  if (summary.exact == summary.answered) return 0;
  if (summary.relative && summary.relative->rms > 0)
    return summary.relative->rms;
  return std::numeric_limits<double>::infinity();
}

}  // namespace truelux
