// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input_arguments.h"

namespace truelux {

OptionRow SceneArgument(std::string& scene) {
  return {.name = "SCENE.obj",
          .target = &scene,
          .value = "FILE",
          .help = "Wavefront OBJ; a face emits Ke of its material",
          .required = true};
}

OptionRow ReceiversArgument(std::optional<std::string>& receivers) {
  return {.name = "RECEIVERS.csv",
          .target = &receivers,
          .value = "FILE",
          .help = "table of receivers; - is standard input"};
}

}  // namespace truelux
