// SPDX-License-Identifier: GPL-3.0-or-later
// A line that tells how far a long run is, on terminals only.

#ifndef TRUELUX_RUN_PROGRESS_H_
#define TRUELUX_RUN_PROGRESS_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace truelux {

/// The text of the line: receivers done, rate, remaining time if the total is
/// known and something is done. things: what is counted.
std::string ProgressText(std::uint64_t done, std::optional<std::uint64_t> total,
                         double seconds, std::string_view things = "receivers");

/// Counts receivers, or other things, and, if standard error is a terminal and
/// the run takes longer than two seconds, shows a line there until it is
/// destroyed.
class Progress {
 public:
  /// total: number of receivers, if known.
  explicit Progress(std::optional<std::uint64_t> total,
                    std::string_view things = "receivers");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So many more are done. Any thread may call it.
  void Advance(std::uint64_t count = 1) {
    done_.fetch_add(count, std::memory_order_relaxed);
  }

  [[nodiscard]] std::uint64_t done() const { return done_; }

 private:
  void Show();

  std::optional<std::uint64_t> total_;
  std::string things_;
  std::atomic<std::uint64_t> done_ = 0;
  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_PROGRESS_H_
