// SPDX-License-Identifier: GPL-3.0-or-later
// truelux isolux: contours of irradiance on a flat surface.

#ifndef TRUELUX_CLI_CMD_ISOLUX_H_
#define TRUELUX_CLI_CMD_ISOLUX_H_

#include "cli/isolux_request.h"
#include "run/exit_status.h"

namespace truelux {

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunIsolux(const IsoluxArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_ISOLUX_H_
