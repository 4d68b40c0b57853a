// SPDX-License-Identifier: GPL-3.0-or-later
// Many receivers at once, spread over threads.

#ifndef TRUELUX_RUN_PARALLEL_H_
#define TRUELUX_RUN_PARALLEL_H_

#include <cstddef>
#include <functional>
#include <span>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"

#include "run/progress.h"

namespace truelux {

/// More threads would only cost memory.
inline constexpr int kMaxThreads = 1024;

/// Throws std::invalid_argument unless it is 1 .. kMaxThreads.
void CheckThreads(int threads);

/// The number of threads that suits this computer, at most kMaxThreads.
int DefaultThreads();

/// How many threads the system gives, 1 .. wanted: limits of users and of
/// containers refuse some. Tried by starting so many at once. Others may use
/// them up meanwhile.
int ThreadsToHave(int wanted);

/// Runs `work` so that what it starts in parallel uses up to `threads` threads,
/// also if there are fewer processors.
void WithThreads(int threads, const std::function<void()>& work);

/// f(0), f(1), .. f(count - 1), each once, in any order on any thread. Throws
/// Stopped within one call per thread after the watch of `progress` asks for it,
/// and what f throws. Counts in `progress`.
void ForEachInParallel(std::size_t count, int threads, Progress& progress,
                       const std::function<void(std::size_t)>& f);

/// Calls take(i, irradiance of receivers[i]) once for each receiver, on any
/// thread. Cheaper where consecutive receivers are near each other. Throws as
/// ForEachInParallel does, and counts receivers.
void EvaluateInParallel(
    const Oracle& oracle, std::span<const Receiver> receivers, int threads,
    Progress& progress,
    const std::function<void(std::size_t, const Irradiance&)>& take);

/// The same within WithThreads, or on one thread outside.
void EvaluateShares(
    const Oracle& oracle, std::span<const Receiver> receivers,
    Progress& progress,
    const std::function<void(std::size_t, const Irradiance&)>& take);

}  // namespace truelux

#endif  // TRUELUX_RUN_PARALLEL_H_
