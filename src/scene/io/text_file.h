// SPDX-License-Identifier: GPL-3.0-or-later
// Whole text files, with the reason if one cannot be read.

#ifndef TRUELUX_SCENE_IO_TEXT_FILE_H_
#define TRUELUX_SCENE_IO_TEXT_FILE_H_

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace truelux {

struct TextFile {
  enum class Status { kRead, kMissing, kUnreadable };
  Status status = Status::kMissing;
  std::string text;    ///< kRead: the content, byte for byte
  std::string reason;  ///< otherwise: why not
};

/// Whatever turns a path into a text: the file system, or a test.
using FileOpener = std::function<TextFile(const std::filesystem::path&)>;

TextFile ReadTextFile(const std::filesystem::path& path);

/// A control character that no text file has.
struct BinaryByte {
  int line = 0;
  int value = 0;
};

/// The first one of a text, if there is any. Blanks, ends of lines and form
/// feeds are text, and so are all bytes from 128 on (UTF-8, Latin-1, ...).
std::optional<BinaryByte> FindBinaryByte(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_TEXT_FILE_H_
