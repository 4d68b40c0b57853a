// SPDX-License-Identifier: GPL-3.0-or-later
// A block is "BYTES HASH NOTE\n" and the bytes; the hash is of the note and the
// bytes.
#include "run/part_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "run/interrupt.h"
#include "run/user_error.h"

namespace truelux {
namespace {

/// No block is larger, so that a damaged length asks for no memory.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

std::string HashOf(std::string_view note, std::string_view bytes) {
  ContentHash hash;
  hash.AddText(note);
  hash.Add(bytes);
  return hash.Text();
}

UserError RefusalOf(const std::string& path, const std::string& why) {
  return UserError({Diagnostic{Severity::kError, path, 0, why}});
}

/// Reads a file from some offset on, in pieces.
class PieceReader {
 public:
  PieceReader(int fd, const std::string& name, std::uint64_t offset)
      : fd_(fd), name_(name), offset_(offset) {}

  /// The line that starts here, without its end; nothing if the file ends
  /// before it does or it is too long.
  std::optional<std::string> Line() {
    constexpr std::size_t kLongest = 1000;
    std::size_t end = 0;
    while ((end = buffer_.find('\n')) == buffer_.npos) {
      if (buffer_.size() > kLongest || !Fill()) return std::nullopt;
    }
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    return line;
  }

  /// So many bytes, or what there is.
  std::string AtMost(std::size_t count) {
    while (buffer_.size() < count && Fill()) {
    }
    std::string bytes = buffer_.substr(0, count);
    buffer_.erase(0, bytes.size());
    return bytes;
  }

  std::optional<std::string> Bytes(std::size_t count) {
    while (buffer_.size() < count) {
      if (!Fill()) return std::nullopt;
    }
    std::string bytes = buffer_.substr(0, count);
    buffer_.erase(0, count);
    return bytes;
  }

 private:
  bool Fill() {
    StopIfInterrupted();
    std::array<char, 1 << 16> piece{};
    const ssize_t n =
        pread(fd_, piece.data(), piece.size(), static_cast<off_t>(offset_));
    if (n < 0) throw UserError(name_, "cannot read", errno);
    buffer_.append(piece.data(), static_cast<std::size_t>(n));
    offset_ += static_cast<std::uint64_t>(n);
    return n > 0;
  }

  int fd_;
  const std::string& name_;
  std::uint64_t offset_;
  std::string buffer_;
};

struct PartBlock {
  std::string note;
  std::string bytes;
  std::uint64_t size = 0;  ///< in the file
};

/// Nothing if what comes is no whole block.
std::optional<PartBlock> ReadBlock(PieceReader& reader) {
  const std::optional<std::string> line = reader.Line();
  if (!line) return std::nullopt;
  const std::size_t first = line->find(' ');
  const std::size_t second = line->find(' ', first + 1);
  if (first == line->npos || second == line->npos) return std::nullopt;
  std::uint64_t count = 0;
  const auto [end, error] =
      std::from_chars(line->data(), line->data() + first, count);
  if (error != std::errc() || end != line->data() + first || count > kMostBytes)
    return std::nullopt;
  PartBlock block;
  block.note = line->substr(second + 1);
  std::optional<std::string> bytes = reader.Bytes(count);
  if (!bytes) return std::nullopt;
  block.bytes = std::move(*bytes);
  block.size = line->size() + 1 + count;
  if (HashOf(block.note, block.bytes) !=
      line->substr(first + 1, second - first - 1))
    return std::nullopt;
  return block;
}

}  // namespace

void ContentHash::Add(std::string_view bytes) {
  constexpr std::uint64_t kPrime = 0x100000001B3U;
  for (const char c : bytes)
    state_ = (state_ ^ static_cast<unsigned char>(c)) * kPrime;
}

void ContentHash::AddText(std::string_view text) {
  Add(fmt::format("{}:", text.size()));
  Add(text);
}

std::string ContentHash::Text() const {
  return fmt::format("{:016x}", state_);
}

PartFile::PartFile(std::string path, const std::string& key,
                   const std::function<void(const std::string&)>& take)
    : path_(std::move(path)) {
  constexpr mode_t kReadWriteForAll = 0666;  // less the umask
  fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kReadWriteForAll);
  if (fd_ < 0) throw UserError(path_, "cannot open", errno);
  try {
    if (flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      throw RefusalOf(path_,
                      "is written by another run, which has to end first");
    ReadAll("truelux part 1 " + key + "\n", take);
  } catch (...) {
    close(fd_);
    throw;
  }
}

PartFile::~PartFile() {
  if (fd_ >= 0) close(fd_);
}

void PartFile::ReadAll(const std::string& head,
                       const std::function<void(const std::string&)>& take) {
  head_size_ = head.size();
  PieceReader reader(fd_, path_, 0);
  const std::string found = reader.AtMost(head.size());
  // A run that was killed at once has written the head in part or not at all.
  const bool is_new = found.size() < head.size() && head.starts_with(found);
  if (!is_new && found != head) {
    throw RefusalOf(
        path_,
        found.starts_with("truelux part ")
            ? "is of another scene, other receivers, other options or another "
              "version; remove it, or give another output"
            : "is no part of an output; remove it, or give another output");
  }
  if (!is_new) {
    size_ = head_size_;
    while (const std::optional<PartBlock> block = ReadBlock(reader)) {
      take(block->note);
      size_ += block->size;
      is_empty_ = false;
    }
  }
  if (ftruncate(fd_, static_cast<off_t>(size_)) != 0)
    throw UserError(path_, "cannot write", errno);
  if (lseek(fd_, 0, SEEK_END) < 0)
    throw UserError(path_, "cannot write", errno);
  if (is_new) {
    size_ = head_size_;
    WriteAll(head);
  }
}

void PartFile::WriteAll(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(fd_, text.data(), text.size());
    if (n >= 0) {
      text.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      throw UserError(path_, "cannot write", errno);
    }
  }
}

void PartFile::Append(std::string_view bytes, const std::string& note) {
  std::string block =
      fmt::format("{} {} {}\n", bytes.size(), HashOf(note, bytes), note);
  block += bytes;
  WriteAll(block);
  size_ += block.size();
  is_empty_ = false;
}

void PartFile::ForEach(
    const std::function<void(std::string_view)>& write) const {
  PieceReader reader(fd_, path_, head_size_);
  std::uint64_t at = head_size_;
  while (at < size_) {
    const std::optional<PartBlock> block = ReadBlock(reader);
    if (!block) throw UserError(path_, "cannot read", EIO);
    write(block->bytes);
    at += block->size;
  }
}

void PartFile::Remove() {
  unlink(path_.c_str());
}

}  // namespace truelux
