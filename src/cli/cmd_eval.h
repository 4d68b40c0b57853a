// truelux eval: the irradiance of receivers in a scene.

#ifndef TRUELUX_CLI_CMD_EVAL_H_
#define TRUELUX_CLI_CMD_EVAL_H_

#include "cli/eval_request.h"
#include "run/exit_status.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace truelux {

/// Adds the command to `app`. Parsing fills `arguments`, which must stay in
/// place until then.
void AddEvalCommand(CLI::App& app, EvalArguments& arguments);

/// Runs it. Throws UserError for bad input, and Interruption.
ExitStatus RunEval(const EvalArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_EVAL_H_
