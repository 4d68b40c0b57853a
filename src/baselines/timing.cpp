// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/timing.h"

#include <chrono>
#include <ctime>

namespace truelux {

double ThreadSeconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

double WallSeconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double SecondsOfRun(const std::function<void()>& run,
                    const double* not_counted) {
  constexpr double kLeastSeconds = 0.005;
  const auto now = [not_counted] {
    return ThreadSeconds() - (not_counted == nullptr ? 0 : *not_counted);
  };
  double begin = now();
  run();
  double seconds = now() - begin;
  if (seconds >= kLeastSeconds) return seconds;
  int runs = 0;
  begin = now();
  for (seconds = 0; seconds < kLeastSeconds; ++runs) {
    run();
    seconds = now() - begin;
  }
  return seconds / runs;
}

}  // namespace truelux
