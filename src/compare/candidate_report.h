// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate held against the truth, as text and as JSON.

#ifndef TRUELUX_COMPARE_CANDIDATE_REPORT_H_
#define TRUELUX_COMPARE_CANDIDATE_REPORT_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/scene.h"

#include "compare/candidate_errors.h"
#include "compare/diagnosis.h"
#include "compare/failure_classes.h"
#include "compare/mistake_trial.h"
#include "explain/receiver_detail.h"

namespace truelux {

/// One of the worst receivers.
struct WorstCandidate {
  std::size_t receiver = 0;  ///< index into CandidateData::receivers
  ReceiverDetail detail;
};

/// Everything that a report says.
struct CandidateReport {
  Scene scene;
  std::string scene_name;
  std::string candidate_name;
  TruthOptions options;
  double tolerance = 0;
  CandidateData data;
  std::vector<CandidateError> errors;  ///< one per receiver
  CandidateSummary summary;
  std::vector<WorstCandidate> worst;  ///< worst first
  Diagnosis diagnosis;
  /// Receivers that were classified; empty unless nothing explains failures.
  std::vector<ClassifiedReceiver> classified;

  [[nodiscard]] bool passes() const { return summary.failing() == 0; }
};

/// How many of the worst receivers are shown.
inline constexpr std::size_t kMostWorstCandidates = 10;

/// "irradiance", "form-factor" or "gradient".
[[nodiscard]] std::string_view Name(Quantity quantity);

/// Lines of text, the last one ended.
[[nodiscard]] std::string CandidateText(const CandidateReport& report);

/// One JSON object, ended by a line end; keys in docs/compare.md. Numbers that
/// are not finite are the strings "inf", "-inf" and "nan".
[[nodiscard]] std::string CandidateJson(const CandidateReport& report,
                                        std::string_view version);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_CANDIDATE_REPORT_H_
