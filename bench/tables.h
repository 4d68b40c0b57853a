// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of results, for people and for programs.

#ifndef TRUELUX_BENCH_TABLES_H_
#define TRUELUX_BENCH_TABLES_H_

#include <string>
#include <vector>

#include "bar.h"
#include "measure.h"
#include "scenes.h"

namespace truelux::bench {

/// Prints what was measured on a scene, and remarks below.
void PrintScene(const BenchScene& scene,
                const std::vector<Measurement>& measurements,
                const std::vector<std::string>& remarks);

/// Prints "what | measured | at most | aim" and how each fares.
void PrintBar(const std::vector<BarRow>& rows);

/// One line per measurement; microseconds are medians.
std::string CsvText(const std::vector<Measurement>& measurements);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_TABLES_H_
