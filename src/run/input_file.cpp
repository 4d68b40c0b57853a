// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/input_file.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include "run/file_id.h"
#include "run/interrupt.h"
#include "run/user_error.h"

namespace truelux {

InputFile::InputFile(const std::string& path)
    : name_(path == "-" ? "<stdin>" : path) {
  if (path == "-") {
    fd_ = STDIN_FILENO;
    return;
  }
  fd_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd_ < 0) {
    const int reason = errno;
    StopIfInterrupted();  // opening a pipe waits for its writer
    throw UserError(name_, "cannot open", reason);
  }
  const std::optional<FileId> id = FileIdOf(fd_);
  can_rewind_ = id && id->IsRegular();
}

InputFile::~InputFile() {
  if (fd_ != STDIN_FILENO) close(fd_);
}

void InputFile::Rewind() {
  if (lseek(fd_, 0, SEEK_SET) != 0) {
    throw UserError(name_, "cannot read again", errno);
  }
}

std::size_t InputFile::Read(std::span<char> buffer) {
  for (;;) {
    WaitUntilReadable(fd_);
    const ssize_t n = read(fd_, buffer.data(), buffer.size());
    if (n >= 0) return static_cast<std::size_t>(n);
    if (errno != EINTR) throw UserError(name_, "cannot read", errno);
  }
}

}  // namespace truelux
