// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison with what all parts of a report derive from it.

#ifndef TRUELUX_STUDY_REPORT_VIEW_H_
#define TRUELUX_STUDY_REPORT_VIEW_H_

#include <cstddef>
#include <string>
#include <vector>

#include "study/comparison.h"
#include "study/comparison_summary.h"

namespace truelux {

struct ReportView {
  /// `compared` must outlive the view.
  explicit ReportView(const Comparison& compared);

  const Comparison& comparison;
  std::vector<std::string> groups;
  std::vector<MethodSummary> summaries;  ///< of the methods, in their order
  std::vector<std::size_t> series;       ///< of the methods: index into groups
  /// The methods with a value at every receiver that no other one of these
  /// beats in time and ErrorInChart, by time.
  std::vector<std::size_t> front;

  [[nodiscard]] bool IsOnFront(std::size_t method) const;
  [[nodiscard]] std::size_t LitReceivers() const;
};

/// A method's error as one number: 0 if all its values are the certified ones,
/// else its relative RMS error, and infinite if all it gets wrong is light
/// where there is none.
[[nodiscard]] double ErrorInChart(const MethodSummary& summary);

}  // namespace truelux

#endif  // TRUELUX_STUDY_REPORT_VIEW_H_
