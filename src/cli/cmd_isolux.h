// SPDX-License-Identifier: GPL-3.0-or-later
// truelux isolux: contours of irradiance on a flat surface.

#ifndef TRUELUX_CLI_CMD_ISOLUX_H_
#define TRUELUX_CLI_CMD_ISOLUX_H_

#include <optional>
#include <string>
#include <vector>

#include "cli/input_arguments.h"
#include "run/exit_status.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct IsoluxArguments {
  SceneArguments scene;
  std::string surface;
  std::optional<std::string> levels;
  std::optional<std::string> count;
  std::optional<std::string> channel;
  std::vector<std::string> outputs;
  std::optional<std::string> lines;
  std::string chord = "0";
  std::string half_width = "0";
  std::string smallest = "0";
  std::optional<std::string> most_triangles;
  std::string method;
  std::string emission;
  std::string threads;
};

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunIsolux(const IsoluxArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_ISOLUX_H_
