// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CLI11: its header takes ten seconds to compile.

#include "cli/parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "run/messages.h"
#include "run/user_error.h"

namespace truelux {
namespace {

/// A blank follows the comma of "-o, --output", as manual pages are made to
/// expect.
class HelpFormatter final : public CLI::Formatter {
 public:
  HelpFormatter() {
    label("Positionals", "Arguments");
    label("REQUIRED", "");
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, is_positional);
    const std::size_t comma = name.find(",-");
    if (comma != std::string::npos) name.insert(comma + 1, " ");
    return name;
  }
};

/// Adds a row by the type of its target.
class RowAdder {
 public:
  RowAdder(CLI::App& command, const OptionRow& row)
      : command_(command), row_(row) {}

  CLI::Option& operator()(bool* given) const {
    return *command_.add_flag(row_.name, *given, row_.help);
  }

  CLI::Option& operator()(std::vector<std::string>* words) const {
    return *command_.add_option(row_.name, *words, row_.help)
                ->expected(1)
                ->take_all();
  }

  template <class Word>
  CLI::Option& operator()(Word* word) const {
    return *command_.add_option(row_.name, *word, row_.help);
  }

 private:
  CLI::App& command_;
  const OptionRow& row_;
};

void AddRow(CLI::App& command, const OptionRow& row) {
  CLI::Option& option = std::visit(RowAdder(command, row), row.target);
  if (row.show_default) option.capture_default_str();
  if (!row.value.empty()) option.type_name(row.value);
  if (!row.choices.empty()) {
    const std::vector<std::string> words(row.choices.begin(),
                                         row.choices.end());
    option.check(CLI::IsMember(words).description(""))
        ->type_name(CLI::detail::join(words, "|"));
  }
  if (row.required) option.required();
}

void AddCommand(CLI::App& app, const Command& command) {
  CLI::App& added = *app.add_subcommand(command.name, command.summary);
  added.group("Commands");
  for (const OptionRow& row : command.options)
    AddRow(added, row);
  added.footer(command.details + "\n" + command.examples + "\n" +
               kExitStatusHelp);
}

std::unique_ptr<CLI::App> AppOf(const Program& program) {
  auto app = std::make_unique<CLI::App>(program.description, program.name);
  // Commands inherit the formatter, so it is set first.
  app->formatter(std::make_shared<HelpFormatter>());
  app->set_version_flag("--version", program.name + " " + program.version);
  app->require_subcommand(1);
  app->footer("Run '" + program.name + " COMMAND --help' for a command.\n\n" +
              kExitStatusHelp);
  for (const Command& command : program.commands)
    AddCommand(*app, command);
  return app;
}

/// What the parser says, in one line.
std::string UsageMessage(const CLI::App& app, const CLI::ParseError& error) {
  const bool no_command = app.get_subcommands().empty();
  const std::vector<std::string> words = app.remaining();
  if (no_command && !words.empty()) {
    return (words.front().starts_with("-") ? "unknown option '"
                                           : "unknown command '") +
           words.front() + "'";
  }
  if (no_command) return "no command given";
  std::string message = error.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

/// The command line is wrong: says why, the synopsis of the command in use, and
/// where to find more.
ExitStatus Refuse(const CLI::App& app, const UsageError& error) {
  Print(error.diagnostics());
  const std::vector<const CLI::App*> commands = app.get_subcommands(
      [](const CLI::App* command) { return command->parsed(); });
  std::string name = app.get_name();
  if (!commands.empty()) name += " " + commands.front()->get_name();
  const CLI::App& used = commands.empty() ? app : *commands.front();
  const std::string usage = CLI::Formatter().make_usage(&used, name);
  PrintLine(usage.substr(0, usage.find('\n')));
  PrintLine("Run '" + name + " --help' for all options.");
  return ExitStatus::kBadInput;
}

}  // namespace

ExitStatus RunCommandLine(const Program& program, int argc,
                          const char* const* argv) {
  const std::unique_ptr<CLI::App> app = AppOf(program);
  try {
    app->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    WriteStandardOutput(app->help());
    return ExitStatus::kDone;
  } catch (const CLI::CallForVersion& version) {
    WriteStandardOutput(std::string(version.what()) + "\n");
    return ExitStatus::kDone;
  } catch (const CLI::ParseError& error) {
    return Refuse(*app, UsageError(UsageMessage(*app, error)));
  }
  for (const Command& command : program.commands) {
    if (!app->got_subcommand(command.name)) continue;
    try {
      return command.run();
    } catch (const UsageError& error) {
      return Refuse(*app, error);
    }
  }
  // The parser asks for a command of the table.
  throw std::logic_error("no command was parsed");
}

}  // namespace truelux
