// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate's gradients held against the truth, as text and as JSON.

#ifndef TRUELUX_COMPARE_GRADIENTS_GRADIENT_REPORT_H_
#define TRUELUX_COMPARE_GRADIENTS_GRADIENT_REPORT_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/comparison.h"
#include "truelux/derivatives.h"
#include "truelux/scene.h"

#include "compare/gradients/gradient_data.h"
#include "compare/gradients/gradient_errors.h"
#include "explain/receiver_detail.h"

namespace truelux {

/// One of the worst receivers.
struct WorstGradient {
  std::size_t receiver = 0;  ///< index into GradientData::receivers
  ReceiverDetail detail;
  std::vector<Kink> kinks;  ///< at it
};

/// Everything that a report says.
struct GradientReport {
  Scene scene;
  std::string scene_name;
  std::string candidate_name;
  Emission emission = Emission::kExitance;
  double tolerance = 0;
  GradientData data;
  std::vector<GradientError> errors;  ///< one per receiver
  GradientErrorSummary summary;
  std::vector<WorstGradient> worst;  ///< worst first
  Diagnosis diagnosis;

  /// A table of which nothing can be compared does not.
  [[nodiscard]] bool passes() const {
    return summary.failing() == 0 && summary.compares_anything();
  }
};

/// Lines of text, the last one ended.
[[nodiscard]] std::string GradientText(const GradientReport& report);

/// One JSON object, ended by a line end; keys in docs/compare.md. Numbers that
/// are not finite are the strings "inf", "-inf" and "nan".
[[nodiscard]] std::string GradientJson(const GradientReport& report,
                                       std::string_view version);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_REPORT_H_
