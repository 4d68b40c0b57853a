// SPDX-License-Identifier: GPL-3.0-or-later
// Commands and their options as plain tables. parser.h turns them into a
// command line.

#ifndef TRUELUX_CLI_OPTION_TABLE_H_
#define TRUELUX_CLI_OPTION_TABLE_H_

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "run/exit_status.h"

namespace truelux {

/// Where the parser puts what the user gives; untouched if nothing is given.
/// The type says how often an option may be given and what follows it:
///   std::string                 one word
///   std::optional<std::string>  one word, and whether it was given
///   std::vector<std::string>    one word each time, any number of times
///   bool                        a flag: no word
using WordTarget = std::variant<std::string*, std::optional<std::string>*,
                                std::vector<std::string>*, bool*>;

/// A row of the table: an option, a flag or an argument without a name.
struct OptionRow {
  /// "-o,--output"; without a dash it is an argument known by its place, as
  /// "SCENE.obj".
  std::string name;
  WordTarget target;
  /// What the help calls the word, as "FILE". Rows with choices leave it empty.
  std::string value = {};
  std::string help = {};
  bool required = false;
  /// The help shows the word that a std::string target has before parsing.
  bool show_default = false;
  /// Constants. The parser refuses all other words; empty: any word is taken.
  std::vector<std::string_view> choices = {};
};

/// A command of the program.
struct Command {
  std::string name;
  std::string summary;   ///< one line for the list of commands
  std::string details;   ///< paragraphs below the options; the last line ended
  std::string examples;  ///< lines below them; the last one ended
  std::vector<OptionRow> options;  ///< in the order of the help text
  /// Called when the targets are filled. Keeps them alive. Throws UsageError,
  /// UserError and Stopped.
  std::function<ExitStatus()> run;
};

}  // namespace truelux

#endif  // TRUELUX_CLI_OPTION_TABLE_H_
