// SPDX-License-Identifier: GPL-3.0-or-later
// How long work takes, measured so that methods can be compared.

#ifndef TRUELUX_BASELINES_TIMING_H_
#define TRUELUX_BASELINES_TIMING_H_

#include <functional>

namespace truelux {

/// Processor time of the calling thread [s].
[[nodiscard]] double ThreadSeconds();

/// Time that has passed [s], from some fixed moment.
[[nodiscard]] double WallSeconds();

/// Processor time of one run [s]. Short runs are repeated, after one that does
/// not count: the method before may have left the caches and the heap in a
/// state whose mending must not be charged here. not_counted: a sum of seconds
/// that runs add to for what is not the measured thing's own; null: none.
[[nodiscard]] double SecondsOfRun(const std::function<void()>& run,
                                  const double* not_counted = nullptr);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_TIMING_H_
