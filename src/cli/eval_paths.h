// Outputs must not destroy inputs, nor each other.

#ifndef TRUELUX_CLI_EVAL_PATHS_H_
#define TRUELUX_CLI_EVAL_PATHS_H_

#include <string>

#include "cli/eval_request.h"

namespace truelux {

/// Throw UserError if both outputs are the same file, or if an output is the
/// file `path` that is read ("-" is standard input), however they are called:
/// symbolic and hard links and redirections count.
void CheckOutputs(const EvalRequest& request);
void CheckInput(const EvalRequest& request, const std::string& path);

}  // namespace truelux

#endif  // TRUELUX_CLI_EVAL_PATHS_H_
