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

double SecondsOfRun(const std::function<void()>& run) {
  constexpr double kLeastSeconds = 0.005;
  double begin = ThreadSeconds();
  run();
  double seconds = ThreadSeconds() - begin;
  if (seconds >= kLeastSeconds) return seconds;
  int runs = 0;
  begin = ThreadSeconds();
  for (seconds = 0; seconds < kLeastSeconds; ++runs) {
    run();
    seconds = ThreadSeconds() - begin;
  }
  return seconds / runs;
}

}  // namespace truelux
