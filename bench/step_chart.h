// SPDX-License-Identifier: GPL-3.0-or-later
// Error of difference quotients against their step, as a picture.

#ifndef TRUELUX_BENCH_STEP_CHART_H_
#define TRUELUX_BENCH_STEP_CHART_H_

#include <string>
#include <vector>

namespace truelux::bench {

/// The error of one method at one step.
struct StepError {
  double step = 0;   ///< [scene length unit]
  double error = 0;  ///< relative
};

/// One method at one receiver, by descending steps.
struct StepCurve {
  std::string receiver;  ///< the title of its panel
  std::string method;    ///< its name in the legend
  std::vector<StepError> points;
};

/// A self-contained SVG: one panel per receiver, both axes logarithmic, one
/// series per method; errors of 0 are left out. Requires that some are left.
std::string StepChart(const std::vector<StepCurve>& curves);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_STEP_CHART_H_
