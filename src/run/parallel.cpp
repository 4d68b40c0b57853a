#include "run/parallel.h"

#include <algorithm>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "run/interrupt.h"

namespace truelux {
namespace {

/// Consecutive receivers that one thread evaluates, so that the oracle can use
/// that they are often near each other; few enough for all threads to have
/// some.
constexpr std::size_t kShare = 16;

}  // namespace

int DefaultThreads() {
  return std::min(kMaxThreads, tbb::info::default_concurrency());
}

void WithThreads(int threads, const std::function<void()>& work) {
  // The control allows more threads than there are cores, if so wished.
  const tbb::global_control control(
      tbb::global_control::max_allowed_parallelism,
      static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute(work);
}

void ForEachInParallel(std::size_t count, int threads, Progress& progress,
                       const std::function<void(std::size_t)>& f) {
  WithThreads(threads, [&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      StopIfInterrupted();
      f(i);
      progress.Advance();
    });
  });
}

void EvaluateInParallel(
    const Oracle& oracle, std::span<const Receiver> receivers, int threads,
    Progress& progress,
    const std::function<void(std::size_t, const Irradiance&)>& take) {
  WithThreads(threads,
              [&] { EvaluateShares(oracle, receivers, progress, take); });
}

void EvaluateShares(
    const Oracle& oracle, std::span<const Receiver> receivers,
    Progress& progress,
    const std::function<void(std::size_t, const Irradiance&)>& take) {
  const std::size_t share_count = (receivers.size() + kShare - 1) / kShare;
  tbb::parallel_for(std::size_t{0}, share_count, [&](std::size_t share) {
    const std::size_t first = share * kShare;
    const std::size_t count = std::min(kShare, receivers.size() - first);
    StopIfInterrupted();
    oracle.Evaluate(receivers.subspan(first, count),
                    [&](std::size_t i, const Irradiance& irradiance) {
                      take(first + i, irradiance);
                      progress.Advance();
                      StopIfInterrupted();
                    });
  });
}

}  // namespace truelux
