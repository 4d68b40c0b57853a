// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace truelux {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

TextFile Failure(int error) {
  const bool missing =
      error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG;
  return {missing ? TextFile::Status::kMissing : TextFile::Status::kUnreadable,
          "", std::generic_category().message(error)};
}

bool IsBinary(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && !(byte >= '\t' && byte <= '\r')) || byte == 0x7F;
}

}  // namespace

TextFile ReadTextFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Failure(EISDIR);
  const std::unique_ptr<std::FILE, CloseFile> file(
      std::fopen(path.c_str(), "rb"));
  if (!file) return Failure(errno);
  TextFile result;
  // Read in pieces: a pipe has no size to ask for.
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const std::size_t count =
        std::fread(piece.data(), 1, piece.size(), file.get());
    result.text.append(piece.data(), count);
    if (count < piece.size()) break;
  }
  if (std::ferror(file.get()) != 0) return Failure(errno);
  result.status = TextFile::Status::kRead;
  return result;
}

std::optional<BinaryByte> FindBinaryByte(std::string_view text) {
  const auto found = std::ranges::find_if(text, IsBinary);
  if (found == text.end()) return std::nullopt;
  const auto line = 1 + std::count(text.begin(), found, '\n');
  return BinaryByte{static_cast<int>(line), static_cast<unsigned char>(*found)};
}

}  // namespace truelux
