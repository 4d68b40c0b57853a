// truelux stability: how many digits each formula keeps in each arithmetic.

#ifndef TRUELUX_CLI_CMD_STABILITY_H_
#define TRUELUX_CLI_CMD_STABILITY_H_

#include <optional>
#include <string>

#include "run/exit_status.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace truelux {

/// The words of the command line, before they are looked at.
struct StabilityArguments {
  std::string cases;
  std::string seed;
  std::string only;
  std::optional<std::string> csv;
};

/// Adds the command to `app`. Parsing fills `arguments`, which must stay in
/// place until then.
void AddStabilityCommand(CLI::App& app, StabilityArguments& arguments);

/// Runs it. kComparisonFailed: a printed bound does not hold. Throws UserError
/// for bad input, and Interruption.
ExitStatus RunStability(const StabilityArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_STABILITY_H_
