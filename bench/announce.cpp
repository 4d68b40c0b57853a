#include "announce.h"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/interrupt.h"

namespace truelux::bench {

void Announce(const std::string& what) {
  StopIfInterrupted();
  if (isatty(STDERR_FILENO) == 0) return;
  constexpr const char* kClearLine = "\r\033[K";
  fmt::print(stderr, "{}{}", kClearLine, what);
  std::fflush(stderr);
}

}  // namespace truelux::bench
