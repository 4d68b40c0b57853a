// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/announce.h"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "run/interrupt.h"

namespace truelux {
namespace {

void ReplaceLine(const std::string& text) {
  if (isatty(STDERR_FILENO) == 0) return;
  constexpr const char* kClearLine = "\r\033[K";
  fmt::print(stderr, "{}{}", kClearLine, text);
  std::fflush(stderr);
}

}  // namespace

void Announce(const std::string& what) {
  ReplaceLine(Interrupted() ? "" : what);
  StopIfInterrupted();
}

}  // namespace truelux
