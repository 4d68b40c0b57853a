// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bytes of a text input come from.

#ifndef TRUELUX_TEXT_BYTE_SOURCE_H_
#define TRUELUX_TEXT_BYTE_SOURCE_H_

#include <cstddef>
#include <span>
#include <string_view>

namespace truelux {

/// A stream of bytes that is read once, from its start to its end.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Fills the front of `buffer`, which is not empty, and returns how many
  /// bytes were read; 0 only at the end. May wait, but returns what there is
  /// rather than wait for a full buffer. Throws if the input cannot be read.
  virtual std::size_t Read(std::span<char> buffer) = 0;
};

/// A text in memory.
class TextSource : public ByteSource {
 public:
  /// `text` must outlive the source.
  explicit TextSource(std::string_view text) : rest_(text) {}

  std::size_t Read(std::span<char> buffer) override {
    const std::size_t n = rest_.copy(buffer.data(), buffer.size());
    rest_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view rest_;
};

}  // namespace truelux

#endif  // TRUELUX_TEXT_BYTE_SOURCE_H_
