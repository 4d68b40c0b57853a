// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that reports as text have in common.

#ifndef TRUELUX_COMPARE_REPORT_LINES_H_
#define TRUELUX_COMPARE_REPORT_LINES_H_

#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <utility>

#include "truelux/comparison.h"

#include "compare/candidate_receivers.h"

namespace truelux {

/// A size with three digits.
[[nodiscard]] std::string Short(double value);

/// The same with its sign.
[[nodiscard]] std::string SignedText(double value);

/// The shortest number that reads back as the value.
[[nodiscard]] std::string Exactly(double value);

/// A report, line by line.
class ReportLines {
 public:
  template <class... Args>
  void Line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format,
                   std::forward<Args>(args)...);
    text_ += '\n';
  }

  /// The number of one of the worst receivers, from 0, and where it is.
  void AddPlace(std::size_t number, const CandidateReceivers& candidate,
                std::size_t receiver);

  /// The diagnosis, without classes of receivers; nothing if nothing fails.
  void AddDiagnosis(const Diagnosis& diagnosis);

  [[nodiscard]] std::string Take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace truelux

#endif  // TRUELUX_COMPARE_REPORT_LINES_H_
