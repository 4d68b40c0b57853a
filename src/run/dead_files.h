// SPDX-License-Identifier: GPL-3.0-or-later
// Temporary files of runs that were killed.

#ifndef TRUELUX_RUN_DEAD_FILES_H_
#define TRUELUX_RUN_DEAD_FILES_H_

#include <string>
#include <string_view>
#include <vector>

namespace truelux {

/// How the names of temporary files of outputs begin and end.
inline constexpr std::string_view kTemporaryStart = ".truelux-";
inline constexpr std::string_view kTemporaryEnd = ".tmp";

/// Removes the temporary files in a folder that no run has any more: a run holds
/// a lock on its file. One that was made less than a minute ago may not have its
/// lock yet and stays. Returns the paths. What cannot be done is left.
std::vector<std::string> RemoveDeadFiles(const std::string& folder);

}  // namespace truelux

#endif  // TRUELUX_RUN_DEAD_FILES_H_
