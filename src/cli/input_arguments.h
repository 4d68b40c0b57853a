// The inputs that commands have in common.

#ifndef TRUELUX_CLI_INPUT_ARGUMENTS_H_
#define TRUELUX_CLI_INPUT_ARGUMENTS_H_

#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
class Option;
}  // namespace CLI

namespace truelux {

/// The argument SCENE.obj, which must be given.
void AddSceneArgument(CLI::App& command, std::string& scene);

/// The argument RECEIVERS.csv, which may be left out unless the caller says
/// otherwise.
CLI::Option& AddReceiversArgument(CLI::App& command,
                                  std::optional<std::string>& receivers);

}  // namespace truelux

#endif  // TRUELUX_CLI_INPUT_ARGUMENTS_H_
