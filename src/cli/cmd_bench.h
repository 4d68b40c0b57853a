// truelux bench: many methods on the receivers of one scene, as a report.

#ifndef TRUELUX_CLI_CMD_BENCH_H_
#define TRUELUX_CLI_CMD_BENCH_H_

#include <optional>
#include <string>

#include "run/exit_status.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace truelux {

/// The words of the command line, before they are looked at.
struct BenchArguments {
  std::string scene;
  std::optional<std::string> receivers;
  std::string output;
  std::string count;
  std::string seed;
  std::optional<std::string> seconds;
  bool quick = false;
  bool arrangement = false;
};

/// Adds the command to `app`. Parsing fills `arguments`, which must stay in
/// place until then.
void AddBenchCommand(CLI::App& app, BenchArguments& arguments);

/// Runs it. Throws UserError for bad input, and Interruption.
ExitStatus RunBench(const BenchArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_BENCH_H_
