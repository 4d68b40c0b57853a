// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program: each a table of options and what it does. The
// list in main.cpp puts them in order.

#ifndef TRUELUX_CLI_COMMANDS_H_
#define TRUELUX_CLI_COMMANDS_H_

#include "cli/option_table.h"

namespace truelux {

/// truelux eval: the irradiance of receivers in a scene.
Command EvalCommand();
/// truelux bench: many methods on the receivers of one scene, as a report.
Command BenchCommand();
/// truelux compare: another program's values, held against the truth.
Command CompareCommand();
/// truelux gradient: derivatives of irradiance.
Command GradientCommand();
/// truelux inspect: all that one receiver sees, as a picture and as numbers.
Command InspectCommand();
/// truelux isolux: contours of irradiance on a flat surface.
Command IsoluxCommand();
/// truelux render: pictures of a scene, one irradiance a pixel.
Command RenderCommand();
/// truelux stability: how many digits each formula keeps in each arithmetic.
Command StabilityCommand();

}  // namespace truelux

#endif  // TRUELUX_CLI_COMMANDS_H_
