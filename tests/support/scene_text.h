// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes from strings.

#ifndef TRUELUX_TESTS_SUPPORT_SCENE_TEXT_H_
#define TRUELUX_TESTS_SUPPORT_SCENE_TEXT_H_

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

#include "scene/io/read_scene.h"

namespace truelux {

/// Texts by path, instead of a file system.
using TextFiles = std::map<std::string, std::string>;

/// The names of the files, and of the folders with files, in a folder.
inline std::vector<std::string> NamesIn(const TextFiles& files,
                                        const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& [name, text] : files) {
    const std::filesystem::path below =
        std::filesystem::path(name).lexically_relative(folder.empty() ? "."
                                                                      : folder);
    if (!below.empty() && *below.begin() != "..") {
      names.insert(below.begin()->string());
    }
  }
  return {names.begin(), names.end()};
}

inline Result<Scene> ReadSceneFrom(const TextFiles& files,
                                   const std::string& obj,
                                   const ReadOptions& options = {}) {
  const auto open = [&](const std::filesystem::path& path) {
    const auto found = files.find(path.string());
    if (found == files.end()) return TextFile{};
    return TextFile{TextFile::Status::kRead, found->second, ""};
  };
  const auto list = [&](const std::filesystem::path& folder) {
    return NamesIn(files, folder);
  };
  return ReadSceneWith({open, list}, obj, options);
}

/// Reads "scene.obj" and "scene.mtl" with these texts. If mtl is not empty
/// and the OBJ has no mtllib, it gets one behind its last line.
inline Result<Scene> ReadSceneText(std::string_view obj,
                                   std::string_view mtl = "",
                                   const ReadOptions& options = {}) {
  TextFiles files{{"scene.obj", std::string(obj)}};
  if (!mtl.empty()) {
    files["scene.mtl"] = mtl;
    const bool is_named = obj.find("mtllib") != std::string_view::npos;
    if (!is_named) files["scene.obj"] += "\nmtllib scene.mtl\n";
  }
  return ReadSceneFrom(files, "scene.obj", options);
}

/// "scene.obj:3: error: ...", one line each.
inline std::string TextOf(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics)
    text += d.Text() + "\n";
  return text;
}

/// The scene of an OBJ text; throws its defects if it has any.
inline Scene SceneFromText(std::string_view obj, std::string_view mtl = "") {
  const Result<Scene> result = ReadSceneText(obj, mtl);
  if (!result.ok()) throw std::invalid_argument(TextOf(result.diagnostics));
  return *result.value;
}

}  // namespace truelux

#endif  // TRUELUX_TESTS_SUPPORT_SCENE_TEXT_H_
