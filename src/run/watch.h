// SPDX-License-Identifier: GPL-3.0-or-later
// Who may end a long run, and who is told how far it is.

#ifndef TRUELUX_RUN_WATCH_H_
#define TRUELUX_RUN_WATCH_H_

#include "truelux/progress.h"
#include "truelux/stop.h"

#include "run/interrupt.h"

namespace truelux {

/// Nobody, unless it says otherwise.
struct Watch {
  const StopFlag* stop = nullptr;  ///< ends the run with Stopped
  ProgressHook hook{};
  bool shows_line = false;  ///< on standard error, if that is a terminal
};

/// The user of the program, before a terminal.
[[nodiscard]] inline Watch UserAtTerminal() {
  return {.stop = InterruptFlag(), .shows_line = true};
}

}  // namespace truelux

#endif  // TRUELUX_RUN_WATCH_H_
