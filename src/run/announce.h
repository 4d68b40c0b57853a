// SPDX-License-Identifier: GPL-3.0-or-later
// What is being done, for whoever waits at a terminal.

#ifndef TRUELUX_RUN_ANNOUNCE_H_
#define TRUELUX_RUN_ANNOUNCE_H_

#include <string>

namespace truelux {

/// Replaces the last line on standard error, if that is a terminal. "": clears
/// the line; to be called before anything is printed. Throws Stopped if
/// the program is interrupted, with the line cleared.
void Announce(const std::string& what);

}  // namespace truelux

#endif  // TRUELUX_RUN_ANNOUNCE_H_
