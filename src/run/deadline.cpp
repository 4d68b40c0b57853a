// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/deadline.h"

#include <chrono>
#include <system_error>

namespace truelux {

Deadline::Deadline(double seconds, StopFlag& flag) {
  try {
    thread_ = std::thread([this, seconds, &flag] { Wait(seconds, flag); });
  } catch (const std::system_error&) {
    // no thread, no deadline
  }
}

Deadline::~Deadline() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Deadline::Wait(double seconds, StopFlag& flag) {
  std::unique_lock lock(mutex_);
  const bool is_early =
      changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                        [this] { return is_over_; });
  if (!is_early) flag = true;
}

}  // namespace truelux
