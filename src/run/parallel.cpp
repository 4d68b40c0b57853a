// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/parallel.h"

#include <algorithm>
#include <latch>
#include <map>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "base/receiver_block.h"

namespace truelux {
namespace {

/// The calling thread's arena of so many threads. It is kept, since oneTBB 2021.8
/// loses 7 kB with every arena in which two threads or more have worked.
tbb::task_arena& ArenaOf(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

void CheckThreads(int threads) {
  if (threads < 1 || threads > kMaxThreads)
    throw std::invalid_argument("threads: expected 1 to 1024");
}

int DefaultThreads() {
  return std::min(kMaxThreads, tbb::info::default_concurrency());
}

int ThreadsToHave(int wanted) {
  std::vector<std::thread> started;
  std::latch all_tried(1);
  try {
    while (static_cast<int>(started.size()) + 1 < wanted)
      started.emplace_back([&all_tried] { all_tried.wait(); });
  } catch (const std::system_error&) {
    // No more than these.
  }
  all_tried.count_down();
  for (std::thread& thread : started)
    thread.join();
  return static_cast<int>(started.size()) + 1;
}

void WithThreads(int threads, const std::function<void()>& work) {
  // More threads than there are cores, if so wished. What is allowed holds for
  // the whole process, so that fewer are a matter of the arena alone.
  std::optional<tbb::global_control> control;
  if (threads > tbb::info::default_concurrency()) {
    control.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads));
  }
  ArenaOf(threads).execute(work);
}

void ForEachInParallel(std::size_t count, int threads, Progress& progress,
                       const std::function<void(std::size_t)>& f) {
  WithThreads(threads, [&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      progress.StopIfAsked();
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
  // In blocks of the oracle's, several at a time while there are many: a call
  // costs as much as some receivers.
  const std::size_t block_count =
      (receivers.size() + kReceiverBlock - 1) / kReceiverBlock;
  const tbb::blocked_range<std::size_t> all(0, block_count);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& blocks) {
    const std::size_t first = blocks.begin() * kReceiverBlock;
    const std::size_t end =
        std::min(blocks.end() * kReceiverBlock, receivers.size());
    progress.StopIfAsked();
    oracle.Evaluate(receivers.subspan(first, end - first),
                    [&](std::size_t i, const Irradiance& irradiance) {
                      take(first + i, irradiance);
                      progress.Advance();
                      progress.StopIfAsked();
                    });
  });
}

}  // namespace truelux
