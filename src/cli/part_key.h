// SPDX-License-Identifier: GPL-3.0-or-later
// What the rows of an evaluation, or the pixels of a picture, depend on.

#ifndef TRUELUX_CLI_PART_KEY_H_
#define TRUELUX_CLI_PART_KEY_H_

#include <filesystem>
#include <string>
#include <vector>

#include "cli/eval_request.h"
#include "cli/render_request.h"

namespace truelux {

/// A hash of the version, the options, and the contents of the scene's files
/// and of the receivers. The number of threads is not in it. files: what the
/// scene was read from. Throws UserError if the receivers cannot be read, and
/// Stopped.
[[nodiscard]] std::string PartKey(
    const EvalRequest& request,
    const std::vector<std::filesystem::path>& files);

/// The same for the pixels of a picture, which may still be coloured otherwise.
[[nodiscard]] std::string PartKey(
    const RenderRequest& request,
    const std::vector<std::filesystem::path>& files);

}  // namespace truelux

#endif  // TRUELUX_CLI_PART_KEY_H_
