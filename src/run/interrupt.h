// SPDX-License-Identifier: GPL-3.0-or-later
// Stopping a run from outside: Ctrl-C and its relatives.

#ifndef TRUELUX_RUN_INTERRUPT_H_
#define TRUELUX_RUN_INTERRUPT_H_

#include "truelux/stop.h"

namespace truelux {

/// From now on SIGINT, SIGTERM and SIGHUP make Interrupted() true. What does not
/// look at it in time, however deep in a library it is, is ended by EndNow
/// after a third of a second, or at the second signal. Writing to a closed pipe
/// is an error like any other.
void CatchSignals();

/// Whether a signal has asked the program to stop.
[[nodiscard]] bool Interrupted();

/// The flag itself, for calls of the library.
[[nodiscard]] const StopFlag* InterruptFlag();

/// Once the work has been left or is done: what remains takes its time.
void NoMoreHurry();

/// Throws Stopped if Interrupted().
void StopIfInterrupted();

/// Waits until a file descriptor can be read, or written, without blocking.
/// Throws Stopped if the program is interrupted meanwhile.
void WaitUntilReadable(int fd);
void WaitUntilWritable(int fd);

}  // namespace truelux

#endif  // TRUELUX_RUN_INTERRUPT_H_
