// SPDX-License-Identifier: GPL-3.0-or-later
// Which methods are measured on which scenes.

#ifndef TRUELUX_BENCH_SUITES_H_
#define TRUELUX_BENCH_SUITES_H_

#include <vector>

#include "measure.h"
#include "options.h"

namespace truelux::bench {

/// Measures all scenes that the options want, and prints the table of each as
/// soon as it is there.
std::vector<Measurement> RunSuites(const Options& options);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_SUITES_H_
