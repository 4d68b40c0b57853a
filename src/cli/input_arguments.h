// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs that commands have in common.

#ifndef TRUELUX_CLI_INPUT_ARGUMENTS_H_
#define TRUELUX_CLI_INPUT_ARGUMENTS_H_

#include <optional>
#include <string>
#include <vector>

#include "truelux/io.h"

#include "cli/option_table.h"

namespace truelux {

/// The words that name a scene and say how it is read.
struct SceneArguments {
  std::string path;
  bool lenient = false;
  bool two_sided = false;
  std::optional<std::string> opaque_from;
};

/// A scene to be read.
struct SceneRequest {
  std::string path;
  ReadOptions options;
};

/// The argument SCENE.obj, which must be given.
OptionRow SceneArgument(SceneArguments& scene);

/// Appends the options that say how the scene is read.
std::vector<OptionRow> WithSceneOptions(std::vector<OptionRow> rows,
                                        SceneArguments& scene);

/// Throws UsageError if a word is none that it may be.
SceneRequest SceneRequestOf(const SceneArguments& scene);

/// The option --on-face.
OptionRow OnFaceOption(std::optional<std::string>& on_face);

/// The argument RECEIVERS.csv, which may be left out unless the caller says
/// otherwise.
OptionRow ReceiversArgument(std::optional<std::string>& receivers);

}  // namespace truelux

#endif  // TRUELUX_CLI_INPUT_ARGUMENTS_H_
