// SPDX-License-Identifier: GPL-3.0-or-later
// Error against time, as a picture.

#ifndef TRUELUX_BENCH_CHART_H_
#define TRUELUX_BENCH_CHART_H_

#include <string>
#include <vector>

#include "measure.h"

namespace truelux::bench {

/// A self-contained SVG: one panel per scene, both axes logarithmic, one
/// series per family of methods; errors of 0 and scenes without measurements
/// are left out. Requires that some are left.
std::string ErrorChart(const std::vector<Measurement>& measurements,
                       const std::vector<std::string>& scenes);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_CHART_H_
