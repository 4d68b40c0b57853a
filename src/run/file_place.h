// SPDX-License-Identifier: GPL-3.0-or-later
// Where a file will be that may not exist yet.

#ifndef TRUELUX_RUN_FILE_PLACE_H_
#define TRUELUX_RUN_FILE_PLACE_H_

#include <string>

namespace truelux {

/// Where a path leads when its symbolic links are followed; the last one may
/// lead to a file that does not exist yet. Throws UserError if the links lead
/// round in a circle.
[[nodiscard]] std::string FollowLinks(const std::string& path);

/// Whether two paths of files that do not exist yet will be one file: the same
/// name in the same folder, whatever the paths call the folder and, where the
/// file system ignores the case of letters, whatever their case. Letters beyond
/// ASCII are compared as they are. Throws as FollowLinks.
[[nodiscard]] bool IsSamePlace(const std::string& a, const std::string& b);

}  // namespace truelux

#endif  // TRUELUX_RUN_FILE_PLACE_H_
