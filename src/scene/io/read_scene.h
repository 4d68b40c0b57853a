// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ and MTL texts -> Scene, wherever the texts come from.

#ifndef TRUELUX_SCENE_IO_READ_SCENE_H_
#define TRUELUX_SCENE_IO_READ_SCENE_H_

#include <filesystem>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/io.h"
#include "truelux/scene.h"

#include "scene/io/text_file.h"

namespace truelux {

/// ReadScene with every file taken from `files`. MTL files are asked for by
/// their names in the OBJ, relative to its folder (library_search.h).
Result<Scene> ReadSceneWith(const SceneFiles& files,
                            const std::filesystem::path& obj,
                            const ReadOptions& options = {});

/// What ReadScene gives, and which files it asked the file system for.
struct SceneAndFiles {
  Result<Scene> scene;
  std::vector<std::filesystem::path> files;  ///< in that order, `obj` first
};

SceneAndFiles ReadSceneAndFiles(const std::filesystem::path& obj,
                                const ReadOptions& options = {});

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_READ_SCENE_H_
