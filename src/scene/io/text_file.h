// SPDX-License-Identifier: GPL-3.0-or-later
// Whole text files, with the reason if one cannot be read.

#ifndef TRUELUX_SCENE_IO_TEXT_FILE_H_
#define TRUELUX_SCENE_IO_TEXT_FILE_H_

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/stop.h"

namespace truelux {

struct TextFile {
  enum class Status { kRead, kMissing, kUnreadable };
  Status status = Status::kMissing;
  std::string text;    ///< kRead: the content, byte for byte
  std::string reason;  ///< otherwise: why not
};

/// Whatever turns a path into a text: the file system, or a test.
using FileOpener = std::function<TextFile(const std::filesystem::path&)>;

/// The names of the files and folders in a folder, in any order; none if it
/// cannot be looked into.
using FolderLister =
    std::function<std::vector<std::string>(const std::filesystem::path&)>;

/// The file system as far as a scene needs it, or a test's.
struct SceneFiles {
  FileOpener open;
  FolderLister list;
};

/// stop: looked at before every piece; throws Stopped.
TextFile ReadTextFile(const std::filesystem::path& path,
                      const StopFlag* stop = nullptr);
std::vector<std::string> ListFolder(const std::filesystem::path& folder);

/// A text without the control characters behind its last statement (NUL, ^Z):
/// some programs end a file, or fill its last block, with them.
std::string_view WithoutTail(std::string_view text);

/// Why some bytes are no text.
struct TextDefect {
  int line = 0;
  std::string what;
};

/// Nothing if the bytes are a text. A control character is none; blanks, ends
/// of lines and form feeds are, and so are all bytes from 128 on (UTF-8,
/// Latin-1, ...).
std::optional<TextDefect> FindTextDefect(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_TEXT_FILE_H_
