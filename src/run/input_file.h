// SPDX-License-Identifier: GPL-3.0-or-later
// A file or standard input as a byte source.

#ifndef TRUELUX_RUN_INPUT_FILE_H_
#define TRUELUX_RUN_INPUT_FILE_H_

#include <cstddef>
#include <span>
#include <string>

#include "text/byte_source.h"

namespace truelux {

/// Read throws UserError if the file cannot be read, Stopped if the
/// program is interrupted.
class InputFile : public ByteSource {
 public:
  /// path: "-" is standard input. Throws UserError if it cannot be opened.
  explicit InputFile(const std::string& path);
  ~InputFile() override;

  /// The path, or a name for standard input; for messages.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Whether it can be read twice: a file that is neither standard input nor
  /// a pipe or device.
  [[nodiscard]] bool CanRewind() const { return can_rewind_; }

  /// Goes back to the start.
  void Rewind();

  std::size_t Read(std::span<char> buffer) override;

 private:
  std::string name_;
  int fd_ = -1;
  bool can_rewind_ = false;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_INPUT_FILE_H_
