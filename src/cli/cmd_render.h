// SPDX-License-Identifier: GPL-3.0-or-later
// truelux render: pictures of a scene, one irradiance a pixel.

#ifndef TRUELUX_CLI_CMD_RENDER_H_
#define TRUELUX_CLI_CMD_RENDER_H_

#include "cli/render_request.h"
#include "run/exit_status.h"

namespace truelux {

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunRender(const RenderArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_RENDER_H_
