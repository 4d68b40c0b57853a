// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/interrupt.h"

#include <atomic>
#include <csignal>
#include <poll.h>
#include <sys/time.h>

#include "run/exit_status.h"
#include "run/last_words.h"

namespace truelux {
namespace {

/// Global, since a signal handler can reach nothing else.
std::atomic<bool> interrupted = false;
/// How long work may go on that does not look up: below the half second within
/// which every signal is to be heard.
constexpr int kPatienceMicroseconds = 350'000;

static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

extern "C" void EndDeaf(int /*signal*/) {
  EndNow("interrupted\n", static_cast<int>(ExitStatus::kInterrupted));
}

/// Asks the program to stop, and sees to it that it does.
extern "C" void SetInterrupted(int signal) {
  if (interrupted.exchange(true)) EndDeaf(signal);
  itimerval patience = {};
  patience.it_value.tv_usec = kPatienceMicroseconds;
  setitimer(ITIMER_REAL, &patience, nullptr);
}

void Catch(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
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
  Catch(SIGALRM, EndDeaf);
  Catch(SIGINT, SetInterrupted);
  Catch(SIGTERM, SetInterrupted);
  struct sigaction hangup = {};
  sigaction(SIGHUP, nullptr, &hangup);
  const bool nohup = hangup.sa_handler == SIG_IGN;
  if (!nohup) Catch(SIGHUP, SetInterrupted);
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  // Writing then fails with a reason, and the temporary file is removed.
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

bool Interrupted() {
  return interrupted;
}

const StopFlag* InterruptFlag() {
  return &interrupted;
}

void NoMoreHurry() {
  const itimerval never = {};
  setitimer(ITIMER_REAL, &never, nullptr);
}

void StopIfInterrupted() {
  if (Interrupted()) throw Stopped();
}

void WaitUntilReadable(int fd) {
  WaitFor(fd, POLLIN);
}

void WaitUntilWritable(int fd) {
  WaitFor(fd, POLLOUT);
}

}  // namespace truelux
