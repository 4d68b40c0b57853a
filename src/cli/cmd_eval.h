// SPDX-License-Identifier: GPL-3.0-or-later
// truelux eval: the irradiance of receivers in a scene.

#ifndef TRUELUX_CLI_CMD_EVAL_H_
#define TRUELUX_CLI_CMD_EVAL_H_

#include "cli/eval_request.h"
#include "run/exit_status.h"

namespace truelux {

/// Runs it. Throws UserError for bad input, and Stopped.
ExitStatus RunEval(const EvalArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_EVAL_H_
