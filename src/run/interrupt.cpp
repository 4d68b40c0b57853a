// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/interrupt.h"

#include <atomic>
#include <csignal>
#include <poll.h>

namespace truelux {
namespace {

/// The only mutable global of the program: a signal handler can reach nothing
/// else.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

extern "C" void SetInterrupted(int /*signal*/) {
  interrupted = true;
}

void Catch(int signal) {
  struct sigaction action = {};
  action.sa_handler = SetInterrupted;
  sigaction(signal, &action, nullptr);
}

void WaitFor(int fd, short events) {
  // A signal may reach another thread than this one, so look up at times.
  constexpr int kMilliseconds = 100;
  pollfd waiting{fd, events, 0};
  do {
    StopIfInterrupted();
  } while (poll(&waiting, 1, kMilliseconds) <= 0);
}

}  // namespace

void CatchSignals() {
  // Also if it was ignored before, as in a shell's background jobs.
  Catch(SIGINT);
  Catch(SIGTERM);
  struct sigaction hangup = {};
  sigaction(SIGHUP, nullptr, &hangup);
  const bool nohup = hangup.sa_handler == SIG_IGN;
  if (!nohup) Catch(SIGHUP);
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  // Writing then fails with a reason, and the temporary file is removed.
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

bool Interrupted() {
  return interrupted;
}

void StopIfInterrupted() {
  if (Interrupted()) throw Interruption{};
}

void WaitUntilReadable(int fd) {
  WaitFor(fd, POLLIN);
}

void WaitUntilWritable(int fd) {
  WaitFor(fd, POLLOUT);
}

}  // namespace truelux
