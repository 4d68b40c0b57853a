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
#include <vector>

#include "base/stop.h"
#include "base/utf16.h"

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

bool IsSpace(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

TextFile ReadTextFile(const std::filesystem::path& path, const StopFlag* stop) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Failure(EISDIR);
  const std::unique_ptr<std::FILE, CloseFile> file(
      std::fopen(path.c_str(), "rb"));
  if (!file) return Failure(errno);
  TextFile result;
  // Read in pieces: a pipe has no size to ask for.
  std::array<char, 1 << 16> piece{};
  for (;;) {
    StopIfAsked(stop);
    const std::size_t count =
        std::fread(piece.data(), 1, piece.size(), file.get());
    result.text.append(piece.data(), count);
    if (count < piece.size()) break;
  }
  if (std::ferror(file.get()) != 0) return Failure(errno);
  result.status = TextFile::Status::kRead;
  return result;
}

std::vector<std::string> ListFolder(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder,
                                            error);
  while (!error && entry != std::filesystem::directory_iterator()) {
    names.push_back(entry->path().filename().string());
    entry.increment(error);
  }
  return names;
}

std::string_view WithoutTail(std::string_view text) {
  const auto last = std::find_if_not(text.rbegin(), text.rend(), [](char c) {
    return IsBinary(c) || IsSpace(c);
  });
  const auto size = static_cast<std::size_t>(text.rend() - last);
  const std::string_view tail = text.substr(size);
  // Without control characters there is nothing to take away.
  return std::ranges::none_of(tail, IsBinary) ? text : text.substr(0, size);
}

std::optional<TextDefect> FindTextDefect(std::string_view text) {
  if (LooksLikeUtf16(text)) {
    return TextDefect{0, "looks like UTF-16, expected UTF-8: save it as UTF-8"};
  }
  const auto found = std::ranges::find_if(text, IsBinary);
  if (found == text.end()) return std::nullopt;
  const auto line = 1 + std::count(text.begin(), found, '\n');
  return TextDefect{static_cast<int>(line),
                    "binary data (a byte " +
                        std::to_string(static_cast<unsigned char>(*found)) +
                        "), expected text"};
}

}  // namespace truelux
