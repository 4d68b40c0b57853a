#include "cli/input_arguments.h"

#include <CLI/CLI.hpp>

namespace truelux {

void AddSceneArgument(CLI::App& command, std::string& scene) {
  command
      .add_option("SCENE.obj", scene,
                  "Wavefront OBJ; a face emits Ke of its material")
      ->type_name("FILE")
      ->required();
}

CLI::Option& AddReceiversArgument(CLI::App& command,
                                  std::optional<std::string>& receivers) {
  return *command
              .add_option("RECEIVERS.csv", receivers,
                          "table of receivers; - is standard input")
              ->type_name("FILE");
}

}  // namespace truelux
