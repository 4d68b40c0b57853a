// SPDX-License-Identifier: GPL-3.0-or-later
// Errors and notes for the user, on standard error, one line each.

#ifndef TRUELUX_RUN_MESSAGES_H_
#define TRUELUX_RUN_MESSAGES_H_

#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"

namespace truelux {

/// Prints a line on standard error. Failures are ignored: there is no place
/// left to report them.
void PrintLine(std::string_view line);

/// Prints each diagnostic on a line of its own.
void Print(const std::vector<Diagnostic>& diagnostics);

/// Prints "note: message".
void PrintNote(const std::string& message);

/// Writes a text to standard output. Throws UserError if that fails.
void WriteStandardOutput(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_RUN_MESSAGES_H_
