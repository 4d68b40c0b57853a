// SPDX-License-Identifier: GPL-3.0-or-later
// What is done of an output, kept beside it until the whole is there.

#ifndef TRUELUX_RUN_PART_FILE_H_
#define TRUELUX_RUN_PART_FILE_H_

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace truelux {

/// A 64-bit hash (FNV-1a) of bytes, piece by piece: tells files apart by
/// accident, not by intent.
class ContentHash {
 public:
  void Add(std::string_view bytes);
  /// Adds a text and its length, so that the ends of texts count.
  void AddText(std::string_view text);
  /// 16 hexadecimal digits.
  [[nodiscard]] std::string Text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325U;
};

/// The file OUT.part: a line that says what it is of, then blocks, each with
/// its length, a line of the caller's and a hash. A block that a crash, a full
/// disk or a power cut has left in pieces, and all behind it, is dropped when
/// the file is opened again.
///
/// Errors are thrown as UserError. Only one run at a time has the file.
class PartFile {
 public:
  /// Opens or makes the file. key: what the output depends on; a file with
  /// another key is refused. take(note): is called for each whole block that
  /// the file has, in their order.
  PartFile(std::string path, const std::string& key,
           const std::function<void(const std::string& note)>& take);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Whether it has no block.
  [[nodiscard]] bool empty() const { return is_empty_; }

  /// note: without a line end.
  void Append(std::string_view bytes, const std::string& note);

  /// Calls write(bytes) for all blocks.
  void ForEach(const std::function<void(std::string_view)>& write) const;

  /// After the whole output has its name.
  void Remove();

 private:
  void ReadAll(const std::string& head,
               const std::function<void(const std::string&)>& take);
  void WriteAll(std::string_view text);

  std::string path_;
  int fd_ = -1;
  bool is_empty_ = true;
  std::uint64_t head_size_ = 0;
  std::uint64_t size_ = 0;  ///< of what is whole
};

}  // namespace truelux

#endif  // TRUELUX_RUN_PART_FILE_H_
