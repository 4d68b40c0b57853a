// SPDX-License-Identifier: GPL-3.0-or-later
// truelux compare: what another program says, held against the truth.

#ifndef TRUELUX_CLI_CMD_COMPARE_H_
#define TRUELUX_CLI_CMD_COMPARE_H_

#include <optional>
#include <string>

#include "cli/input_arguments.h"
#include "run/exit_status.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct CompareArguments {
  SceneArguments scene;
  std::optional<std::string> candidate;
  std::optional<std::string> on_face;
  std::optional<std::string> output;
  std::optional<std::string> json;
  std::string quantity;
  std::optional<std::string> channel;
  std::string tolerance;
  std::string emission;
  std::string threads;
};

/// Runs it: kComparisonFailed if a receiver fails. Throws UserError for bad
/// input, and Stopped.
ExitStatus RunCompare(const CompareArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_COMPARE_H_
