// SPDX-License-Identifier: GPL-3.0-or-later
// truelux gradient: derivatives of irradiance.

#ifndef TRUELUX_CLI_CMD_GRADIENT_H_
#define TRUELUX_CLI_CMD_GRADIENT_H_

#include <optional>
#include <string>

#include "cli/input_arguments.h"
#include "run/exit_status.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct GradientArguments {
  SceneArguments scene;
  std::optional<std::string> receivers;
  std::optional<std::string> on_face;
  std::optional<std::string> output;
  std::string of;
  std::optional<std::string> kinks;
  std::optional<std::string> vertices;
  std::optional<std::string> vertex_gradient;
  std::optional<std::string> stats;
  std::string method;
  std::string emission;
  std::string threads;
};

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunGradient(const GradientArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_GRADIENT_H_
