// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program, from tables of commands.

#ifndef TRUELUX_CLI_PARSER_H_
#define TRUELUX_CLI_PARSER_H_

#include <string>
#include <vector>

#include "cli/option_table.h"
#include "run/exit_status.h"

namespace truelux {

/// What the program says about itself, and its commands in the order of the
/// help text.
struct Program {
  std::string name;
  std::string description;
  std::string version;
  std::vector<Command> commands;
};

/// Parses the words and runs the command that they name. --help and --version
/// are answered on standard output. A wrong command line, whether the parser or
/// the command says so by UsageError, is answered on standard error with the
/// synopsis of the command, and is kBadInput. Passes on whatever else the
/// command throws.
ExitStatus RunCommandLine(const Program& program, int argc,
                          const char* const* argv);

}  // namespace truelux

#endif  // TRUELUX_CLI_PARSER_H_
