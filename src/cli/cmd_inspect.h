// SPDX-License-Identifier: GPL-3.0-or-later
// truelux inspect: all that one receiver sees, as a picture and as numbers.

#ifndef TRUELUX_CLI_CMD_INSPECT_H_
#define TRUELUX_CLI_CMD_INSPECT_H_

#include <optional>
#include <string>

#include "cli/input_arguments.h"
#include "run/exit_status.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct InspectArguments {
  SceneArguments scene;
  std::string at;
  std::string normal;
  std::optional<std::string> on_face;
  std::optional<std::string> output;
  std::optional<std::string> json;
  std::string projection;
  std::string size;
  std::string emission;
};

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunInspect(const InspectArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_INSPECT_H_
