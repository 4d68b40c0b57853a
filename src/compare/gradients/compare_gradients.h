// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene and a candidate's gradients to everything that a report says.

#ifndef TRUELUX_COMPARE_GRADIENTS_COMPARE_GRADIENTS_H_
#define TRUELUX_COMPARE_GRADIENTS_COMPARE_GRADIENTS_H_

#include "truelux/scene.h"

#include "compare/compare_run.h"
#include "compare/gradients/gradient_data.h"
#include "compare/gradients/gradient_report.h"
#include "compare/gradients/gradient_trial.h"

namespace truelux {

/// Finds the truth, the errors, the worst receivers and, if a receiver fails,
/// the reason. data: without the truth. The names in the report are left empty.
/// Throws Stopped.
[[nodiscard]] GradientReport CompareGradientData(
    const Scene& scene, GradientData data, const CompareSettings& settings);

/// The reason why receivers fail. errors: ErrorsOf(data, tolerance). What
/// `evaluate` throws ends it.
[[nodiscard]] Diagnosis DiagnoseGradients(const Oracle& oracle,
                                          const GradientData& data,
                                          std::span<const GradientError> errors,
                                          double tolerance,
                                          const GradientEvaluators& evaluate);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_COMPARE_GRADIENTS_H_
