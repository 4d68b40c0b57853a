// SPDX-License-Identifier: GPL-3.0-or-later
// truelux bench: many methods on the receivers of one scene, as a report.

#ifndef TRUELUX_CLI_CMD_BENCH_H_
#define TRUELUX_CLI_CMD_BENCH_H_

#include <optional>
#include <string>

#include "cli/input_arguments.h"
#include "run/exit_status.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct BenchArguments {
  SceneArguments scene;
  std::optional<std::string> receivers;
  std::optional<std::string> on_face;
  std::string output;
  std::string count;
  std::string seed;
  std::optional<std::string> seconds;
  bool quick = false;
  bool arrangement = false;
};

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunBench(const BenchArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_BENCH_H_
