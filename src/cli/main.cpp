// SPDX-License-Identifier: GPL-3.0-or-later
// The program truelux: commands, help, and what the exit status says.

#include <algorithm>
#include <exception>
#include <fcntl.h>
#include <new>
#include <string>
#include <unistd.h>

#include "truelux/stop.h"
#include "truelux/version.h"

#include "cli/commands.h"
#include "cli/parser.h"
#include "run/exit_status.h"
#include "run/interrupt.h"
#include "run/last_words.h"
#include "run/messages.h"
#include "run/output_file.h"
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

ExitStatus Run(int argc, char** argv) {
  return RunCommandLine(
      {.name = "truelux",
       .description = "Exact irradiance from polygons that others partly hide.",
       .version = std::string(VersionText()),
       .commands = {EvalCommand(), BenchCommand(), CompareCommand(),
                    GradientCommand(), InspectCommand(), IsoluxCommand(),
                    RenderCommand(), StabilityCommand()}},
      argc, argv);
}

/// Run, with every way to fail turned into a line and an exit status.
ExitStatus RunGuarded(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const UserError& error) {
    Print(error.diagnostics());
    return ExitStatus::kBadInput;
  } catch (const Stopped&) {  // by a signal
    NoMoreHurry();
    PrintLine("interrupted");
    return ExitStatus::kInterrupted;
  } catch (const ReaderGone&) {
    return ExitStatus::kDone;
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

/// Before what is initialized at the start, since that may lack memory, too.
[[gnu::constructor(101)]] static void BeforeAllElse() {
  truelux::EndWhereNothingHelps();
}

int main(int argc, char** argv) {
  truelux::OccupyStandardStreams();
  truelux::CatchSignals();
  return static_cast<int>(truelux::RunGuarded(argc, argv));
}
