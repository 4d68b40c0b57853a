// SPDX-License-Identifier: GPL-3.0-or-later
// Which files a mtllib statement means.

#ifndef TRUELUX_SCENE_IO_LIBRARY_SEARCH_H_
#define TRUELUX_SCENE_IO_LIBRARY_SEARCH_H_

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/io/text_file.h"

namespace truelux {

/// The readings of what follows mtllib, as lists of names, the likeliest first:
/// the whole line, without its quotes, with "\ " as a blank, split at blanks,
/// split after each ".mtl". Readings that repeat an earlier one are left out.
std::vector<std::vector<std::string>> LibraryReadings(std::string_view line);

/// A file that a name stands for.
struct FoundLibrary {
  std::string name;            ///< as mtllib has it
  std::filesystem::path path;  ///< where it is
  bool is_literal = true;      ///< whether `path` is the name in the folder
};

/// Looks for files beside an OBJ, each file once.
class LibrarySearch {
 public:
  /// folder: of the OBJ. `files` must outlive the object.
  LibrarySearch(const SceneFiles& files, std::filesystem::path folder)
      : files_(files), folder_(std::move(folder)) {}

  /// The files of the first reading whose names are all found, else of the
  /// first with one that is; files beside the OBJ of names that lead elsewhere
  /// count only if no reading is found whole without them. missing: the names of that reading that are not
  /// found; the whole line, if no reading has a file.
  std::vector<FoundLibrary> Find(std::string_view line,
                                 std::vector<std::string>& missing);

  /// The content of a file, which is opened once.
  const TextFile& Open(const std::filesystem::path& path);

 private:
  /// Where a name may lead.
  enum class Reach { kNamed, kBeside };

  std::optional<FoundLibrary> FindName(const std::string& name, Reach reach);
  std::optional<std::filesystem::path> InAnotherCase(const std::string& name);
  const std::vector<std::string>& NamesIn(const std::filesystem::path& folder);

  const SceneFiles& files_;
  std::filesystem::path folder_;
  std::map<std::filesystem::path, TextFile> opened_;
  std::map<std::filesystem::path, std::vector<std::string>> listed_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_LIBRARY_SEARCH_H_
