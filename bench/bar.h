// SPDX-License-Identifier: GPL-3.0-or-later
// The bar: what truelux must not cost, in ratios that hold on any machine.

#ifndef TRUELUX_BENCH_BAR_H_
#define TRUELUX_BENCH_BAR_H_

#include <optional>
#include <string>
#include <vector>

#include "measure.h"

namespace truelux::bench {

/// One demand.
struct BarRow {
  std::string what;
  std::optional<double> measured;
  double at_most = 0;
  std::optional<double> aim;
  std::string reason;  ///< why nothing was measured
};

/// The demands on what RunSuites measured.
std::vector<BarRow> RatioRows(const std::vector<Measurement>& measurements);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_BAR_H_
