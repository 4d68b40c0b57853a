// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs that commands have in common.

#ifndef TRUELUX_CLI_INPUT_ARGUMENTS_H_
#define TRUELUX_CLI_INPUT_ARGUMENTS_H_

#include <optional>
#include <string>

#include "cli/option_table.h"

namespace truelux {

/// The argument SCENE.obj, which must be given.
OptionRow SceneArgument(std::string& scene);

/// The argument RECEIVERS.csv, which may be left out unless the caller says
/// otherwise.
OptionRow ReceiversArgument(std::optional<std::string>& receivers);

}  // namespace truelux

#endif  // TRUELUX_CLI_INPUT_ARGUMENTS_H_
