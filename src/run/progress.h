// SPDX-License-Identifier: GPL-3.0-or-later
// How far a long run is, for who watches it.

#ifndef TRUELUX_RUN_PROGRESS_H_
#define TRUELUX_RUN_PROGRESS_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "base/stop.h"
#include "run/watch.h"

namespace truelux {

/// What is counted unless something else is said.
inline constexpr std::string_view kReceivers = "receivers";

/// The text of the line: receivers done, rate, remaining time if the total is
/// known and something is done. things: what is counted.
std::string ProgressText(std::uint64_t done, std::optional<std::uint64_t> total,
                         double seconds, std::string_view things = kReceivers);

/// Counts receivers, or other things, until it is destroyed. The line appears if
/// standard error is a terminal and the run takes longer than two seconds.
/// Padding keeps its cache lines apart.
class Progress {  // NOLINT(clang-analyzer-optin.performance.Padding)
 public:
  /// total: number of receivers, if known; a hook is told 0 if it is not.
  explicit Progress(std::optional<std::uint64_t> total,
                    std::string_view things = kReceivers,
                    Watch watch = UserAtTerminal());
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So many more are done. Any thread may call it.
  void Advance(std::uint64_t count = 1) {
    done_.fetch_add(count, std::memory_order_relaxed);
    if (watch_.hook) TellAtTimes();
  }

  [[nodiscard]] std::uint64_t done() const { return done_; }

  /// Throws Stopped if the run is to end. Any thread may call it.
  void StopIfAsked() const { truelux::StopIfAsked(watch_.stop); }

 private:
  void Show();
  void TellAtTimes();
  void Tell();

  Watch watch_;
  std::optional<std::uint64_t> total_;
  std::string things_;
  /// Alone on its cache line: all threads write it, and read what is beside it.
  alignas(64) std::atomic<std::uint64_t> done_ = 0;
  alignas(64) std::mutex telling_;
  std::chrono::steady_clock::time_point told_{};  ///< guarded by telling_
  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_PROGRESS_H_
