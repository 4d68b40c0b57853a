// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

namespace truelux {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kQuietTime(2);
constexpr std::chrono::milliseconds kPeriod(250);
constexpr std::chrono::milliseconds kTellingPeriod(100);

std::string DurationText(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string ProgressText(std::uint64_t done, std::optional<std::uint64_t> total,
                         double seconds, std::string_view things) {
  const double rate = static_cast<double>(done) / seconds;
  std::string text = fmt::format("{}", done);
  if (total) text += fmt::format(" of {}", *total);
  text += fmt::format(" {}, {:.{}f}/s", things, rate, rate < 10 ? 2 : 0);
  if (total && done > 0) {
    const double left =
        static_cast<double>(*total - std::min(done, *total)) / rate;
    text += fmt::format(", {} left", DurationText(left));
  }
  return text;
}

Progress::Progress(std::optional<std::uint64_t> total, std::string_view things,
                   Watch watch)
    : watch_(std::move(watch)), total_(total), things_(things) {
  if (watch_.shows_line && isatty(STDERR_FILENO) != 0)
    thread_ = std::thread([this] { Show(); });
}

Progress::~Progress() {
  if (watch_.hook) Tell();
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stop_signal_.notify_one();
  thread_.join();
}

void Progress::TellAtTimes() {
  const std::unique_lock lock(telling_, std::try_to_lock);
  if (!lock) return;  // another thread tells
  const Clock::time_point now = Clock::now();
  if (now - told_ < kTellingPeriod) return;
  told_ = now;
  Tell();
}

void Progress::Tell() {
  watch_.hook({done(), total_.value_or(0), things_});
}

void Progress::Show() {
  const Clock::time_point start = Clock::now();
  const auto stopped = [this] { return stop_; };
  std::size_t shown = 0;
  std::unique_lock lock(mutex_);
  bool end = stop_signal_.wait_for(lock, kQuietTime, stopped);
  while (!end) {
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    const std::string text =
        ProgressText(done(), total_, elapsed.count(), things_);
    // Blanks cover what a longer line left.
    const std::string line = fmt::format("\r{:<{}}", text, shown);
    shown = text.size();
    std::fwrite(line.data(), 1, line.size(), stderr);
    end = stop_signal_.wait_for(lock, kPeriod, stopped);
  }
  const std::string cleared =
      shown == 0 ? "" : fmt::format("\r{:{}}\r", "", shown);
  std::fwrite(cleared.data(), 1, cleared.size(), stderr);
}

}  // namespace truelux
