// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input_arguments.h"

#include <fmt/format.h>

#include "cli/option_values.h"
#include "run/interrupt.h"
#include "run/user_error.h"

namespace truelux {

OptionRow SceneArgument(SceneArguments& scene) {
  return {.name = "SCENE.obj",
          .target = &scene.path,
          .value = "FILE",
          .help = "Wavefront OBJ; a face emits Ke of its material",
          .required = true};
}

std::vector<OptionRow> WithSceneOptions(std::vector<OptionRow> rows,
                                        SceneArguments& scene) {
  rows.push_back({.name = "--lenient",
                  .target = &scene.lenient,
                  .help = "leave out faces that are errors, and take faces of "
                          "undefined materials as blockers; notes count them"});
  rows.push_back({.name = "--two-sided",
                  .target = &scene.two_sided,
                  .help = "faces that emit do so to both sides"});
  rows.push_back({.name = "--opaque-from",
                  .target = &scene.opaque_from,
                  .value = "D",
                  .help = "leave out faces that do not emit and whose material "
                          "has d (or 1 - Tr) below D"});
  return rows;
}

SceneRequest SceneRequestOf(const SceneArguments& scene) {
  SceneRequest request;
  request.path = PathValue("SCENE.obj", scene.path);
  request.options.lenient = scene.lenient;
  request.options.two_sided = scene.two_sided;
  request.options.stop = InterruptFlag();
  if (!scene.opaque_from) return request;
  request.options.opaque_from = ParseNumber(*scene.opaque_from);
  const std::optional<double>& limit = request.options.opaque_from;
  if (!limit || *limit < 0 || *limit > 1) {
    throw UsageError(fmt::format("--opaque-from: '{}' is no number from 0 to 1",
                                 *scene.opaque_from));
  }
  return request;
}

OptionRow OnFaceOption(std::optional<std::string>& on_face) {
  return {.name = "--on-face",
          .target = &on_face,
          .value = "N|NAME|auto[:D]",
          .help =
              "the face on which a receiver lies up to rounding, so that\n"
              "it is not seen: its number; the nearest of an object or\n"
              "group NAME; or auto, the nearest within rounding (or D)\n"
              "that is turned like the normal"};
}

OptionRow ReceiversArgument(std::optional<std::string>& receivers) {
  return {.name = "RECEIVERS.csv",
          .target = &receivers,
          .value = "FILE",
          .help = "table of receivers; - is standard input"};
}

}  // namespace truelux
