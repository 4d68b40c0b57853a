// SPDX-License-Identifier: GPL-3.0-or-later
// The options that say how an oracle answers, for all commands that ask one.

#ifndef TRUELUX_CLI_ORACLE_ARGUMENTS_H_
#define TRUELUX_CLI_ORACLE_ARGUMENTS_H_

#include <string>

#include "truelux/irradiance.h"

#include "cli/option_table.h"

namespace truelux {

/// Each is a row of a command's table and sets `word` to its default; the
/// parser then puts the user's word there.
OptionRow MethodOption(std::string& word);
OptionRow EngineOption(std::string& word);
OptionRow EmissionOption(std::string& word);
OptionRow ThreadsOption(std::string& word);

/// What the words mean, once the parser has accepted them.
Method MethodOf(const std::string& word);
Engine EngineOf(const std::string& word);
Emission EmissionOf(const std::string& word);
/// Throws UsageError if it is not a number of threads.
int ThreadsOf(const std::string& word);

}  // namespace truelux

#endif  // TRUELUX_CLI_ORACLE_ARGUMENTS_H_
