// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruptible.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <optional>
#include <unistd.h>

namespace truelux::python {
namespace {

// A signal handler reaches nothing but what is global. Only the main thread
// writes these, one call at a time.
std::atomic<StopFlag*> asked_to_stop = nullptr;
struct sigaction before = {};

extern "C" void OnInterrupt(int signal, siginfo_t* info, void* context) {
  if (StopFlag* flag = asked_to_stop.load()) flag->store(true);
  if ((before.sa_flags & SA_SIGINFO) != 0) {
    before.sa_sigaction(signal, info, context);
  } else if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) {
    before.sa_handler(signal);
  }
}

/// The calling thread's arena of so many threads. It is kept, since oneTBB 2021.8
/// loses 7 kB with every arena in which two threads or more have worked.
tbb::task_arena& ArenaOf(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  return arenas.try_emplace(threads, threads).first->second;
}

bool IsMainThread() {
  const auto threading = pybind11::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

}  // namespace

Interruptible::Interruptible() {
  if (IsMainThread()) {
    if (const StopFlag* outer = asked_to_stop.load()) {
      flag_ = outer;
    } else {
      Catch();
    }
  }
  thread_ = PyEval_SaveThread();
}

/// An interrupt that Python does not handle ends the process, or nothing does.
void Interruptible::Catch() {
  if (sigaction(SIGINT, nullptr, &before) != 0 ||
      ((before.sa_flags & SA_SIGINFO) == 0 &&
       (before.sa_handler == SIG_DFL || before.sa_handler == SIG_IGN))) {
    return;
  }
  struct sigaction action = {};
  action.sa_sigaction = OnInterrupt;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigemptyset(&action.sa_mask);
  asked_to_stop.store(&own_);
  handles_ = sigaction(SIGINT, &action, nullptr) == 0;
  if (!handles_) asked_to_stop.store(nullptr);
}

Interruptible::~Interruptible() {
  try {
    PyEval_RestoreThread(thread_);
  } catch (...) {
    StayForEver();
  }
  if (!handles_) return;
  sigaction(SIGINT, &before, nullptr);
  asked_to_stop.store(nullptr);
}

void StayForEver() {
  for (;;)
    pause();
}

void ForBlocks(std::size_t count, int threads,
               const std::function<void(std::size_t, std::size_t)>& work) {
  constexpr std::size_t kBlocksOfThread = 4;
  const auto thread_count = static_cast<std::size_t>(
      threads > 0 ? threads : tbb::info::default_concurrency());
  const std::size_t size = std::clamp(count / (kBlocksOfThread * thread_count),
                                      kSmallestBlock, kLargestBlock);
  const std::size_t blocks = (count + size - 1) / size;
  const auto block = [&](std::size_t b) {
    const std::size_t first = b * size;
    work(first, std::min(size, count - first));
  };
  if (blocks <= 1 || threads == 1) {
    for (std::size_t b = 0; b < blocks; ++b)
      block(b);
    return;
  }
  const auto all = [&] { tbb::parallel_for(std::size_t{0}, blocks, block); };
  if (threads == 0) {
    all();
    return;
  }
  // More threads than there are cores, if so wished. What is allowed holds for
  // the whole process, so that fewer are a matter of the arena alone.
  std::optional<tbb::global_control> control;
  if (threads > tbb::info::default_concurrency()) {
    control.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads));
  }
  ArenaOf(threads).execute(all);
}

}  // namespace truelux::python
