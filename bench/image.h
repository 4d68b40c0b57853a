// SPDX-License-Identifier: GPL-3.0-or-later
// An image's worth of receivers, and reading a large scene: seconds, not
// ratios.

#ifndef TRUELUX_BENCH_IMAGE_H_
#define TRUELUX_BENCH_IMAGE_H_

#include <vector>

#include "bar.h"
#include "options.h"

namespace truelux::bench {

/// Measures a grid of receivers on one thread, all together and by kind of
/// receiver, and on two threads against one. Prints what it found; the rows
/// are its demands.
std::vector<BarRow> MeasureGrid(const Options& options);

/// Writes a scene of a million triangles to a temporary folder, reads and
/// indexes it.
std::vector<BarRow> MeasureLoading(const Options& options);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_IMAGE_H_
