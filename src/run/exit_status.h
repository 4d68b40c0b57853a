// SPDX-License-Identifier: GPL-3.0-or-later
// What the program's exit status says.

#ifndef TRUELUX_RUN_EXIT_STATUS_H_
#define TRUELUX_RUN_EXIT_STATUS_H_

namespace truelux {

enum class ExitStatus : int {
  kDone = 0,
  kComparisonFailed = 1,
  kBadInput = 2,       ///< or wrong usage, or an output that cannot be written
  kInternalError = 3,  ///< a defect of this program
  kInterrupted = 130,  ///< 128 + SIGINT, also after other signals
};

/// The table for help texts.
inline constexpr const char* kExitStatusHelp =
    "Exit status:\n"
    "  0    done\n"
    "  1    a comparison failed\n"
    "  2    bad input or usage, or the output could not be written\n"
    "  3    internal error\n"
    "  130  interrupted";

}  // namespace truelux

#endif  // TRUELUX_RUN_EXIT_STATUS_H_
