// The program truelux: commands, help, and what the exit status says.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fcntl.h>
#include <new>
#include <string>
#include <unistd.h>

#include "truelux/version.h"

#include "cli/cmd_bench.h"
#include "cli/cmd_compare.h"
#include "cli/cmd_eval.h"
#include "cli/cmd_inspect.h"
#include "cli/cmd_render.h"
#include "cli/cmd_stability.h"
#include "cli/help_format.h"
#include "run/exit_status.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/user_error.h"

namespace truelux {
namespace {

/// If a standard stream is closed, the next file to be opened would take its
/// place, and messages or results would be written into it. A stand-in that
/// cannot be used that way makes this an error instead.
void OccupyStandardStreams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(fd, F_GETFD) >= 0) continue;
    open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
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

/// The synopsis of the command in use, and where to find more.
void PrintUsage(const CLI::App& app) {
  const std::vector<const CLI::App*> commands = app.get_subcommands(
      [](const CLI::App* command) { return command->parsed(); });
  std::string name = "truelux";
  if (!commands.empty()) name += " " + commands.front()->get_name();
  const CLI::App& used = commands.empty() ? app : *commands.front();
  const std::string usage = CLI::Formatter().make_usage(&used, name);
  PrintLine(usage.substr(0, usage.find('\n')));
  PrintLine("Run '" + name + " --help' for all options.");
}

ExitStatus Run(int argc, char** argv) {
  CLI::App app("Exact irradiance from polygons that others partly hide.",
               "truelux");
  app.formatter(MakeHelpFormatter());
  app.set_version_flag("--version", std::string("truelux ") + VersionText());
  app.require_subcommand(1);
  app.footer(std::string("Run 'truelux COMMAND --help' for a command.\n\n") +
             kExitStatusHelp);
  EvalArguments eval;
  AddEvalCommand(app, eval);
  BenchArguments bench;
  AddBenchCommand(app, bench);
  CompareArguments compare;
  AddCompareCommand(app, compare);
  InspectArguments inspect;
  AddInspectCommand(app, inspect);
  RenderArguments render;
  AddRenderCommand(app, render);
  StabilityArguments stability;
  AddStabilityCommand(app, stability);
  for (CLI::App* command : app.get_subcommands({}))
    command->group("Commands");
  try {
    app.parse(argc, argv);
    if (app.got_subcommand("bench")) return RunBench(bench);
    if (app.got_subcommand("compare")) return RunCompare(compare);
    if (app.got_subcommand("inspect")) return RunInspect(inspect);
    if (app.got_subcommand("render")) return RunRender(render);
    if (app.got_subcommand("stability")) return RunStability(stability);
    return RunEval(eval);
  } catch (const CLI::CallForHelp&) {
    WriteStandardOutput(app.help());
    return ExitStatus::kDone;
  } catch (const CLI::CallForVersion& version) {
    WriteStandardOutput(std::string(version.what()) + "\n");
    return ExitStatus::kDone;
  } catch (const CLI::ParseError& error) {
    Print(UsageError(UsageMessage(app, error)).diagnostics());
    PrintUsage(app);
    return ExitStatus::kBadInput;
  } catch (const UsageError& error) {
    Print(error.diagnostics());
    PrintUsage(app);
    return ExitStatus::kBadInput;
  }
}

/// Run, with every way to fail turned into a line and an exit status.
ExitStatus RunGuarded(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const UserError& error) {
    Print(error.diagnostics());
    return ExitStatus::kBadInput;
  } catch (const Interruption&) {
    PrintLine("interrupted");
    return ExitStatus::kInterrupted;
  } catch (const std::bad_alloc&) {
    PrintLine("internal error: out of memory");
  } catch (const std::exception& error) {
    std::string message = error.what();
    std::replace(message.begin(), message.end(), '\n', ' ');
    PrintLine("internal error: " + message);
  } catch (...) {
    PrintLine("internal error: unknown exception");
  }
  return ExitStatus::kInternalError;
}

}  // namespace
}  // namespace truelux

int main(int argc, char** argv) {
  truelux::OccupyStandardStreams();
  truelux::CatchSignals();
  return static_cast<int>(truelux::RunGuarded(argc, argv));
}
