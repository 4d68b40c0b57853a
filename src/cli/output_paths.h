// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs must not destroy inputs, nor each other.

#ifndef TRUELUX_CLI_OUTPUT_PATHS_H_
#define TRUELUX_CLI_OUTPUT_PATHS_H_

#include <string>
#include <vector>

namespace truelux {

/// A file that a command writes.
struct OutputPath {
  std::string option;  ///< that names it, for messages
  std::string path;    ///< "": standard output
};

using OutputPaths = std::vector<OutputPath>;

/// CheckOutputs also removes the temporary files of killed runs where outputs
/// will be, and names them. Both throw UserError if two outputs are the same file, or if an output is the
/// file `path` that is read ("-" is standard input), however they are called:
/// symbolic and hard links and redirections count.
void CheckOutputs(const OutputPaths& outputs);
void CheckInput(const OutputPaths& outputs, const std::string& path);

}  // namespace truelux

#endif  // TRUELUX_CLI_OUTPUT_PATHS_H_
