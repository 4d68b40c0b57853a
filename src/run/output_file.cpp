// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/output_file.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "run/dead_files.h"
#include "run/file_place.h"
#include "run/interrupt.h"
#include "run/user_error.h"

namespace truelux {
namespace fs = std::filesystem;

OutputFile::OutputFile(const std::string& path) : name_(path) {
  const std::optional<FileId> standard_output = FileIdOf(STDOUT_FILENO);
  const std::optional<FileId> existing = FileIdOf(path);
  const bool is_standard_output =
      path.empty() || path == "-" ||
      (existing && standard_output && *existing == *standard_output);
  if (is_standard_output) {
    if (path.empty() || path == "-") name_ = "<stdout>";
    fd_ = STDOUT_FILENO;
    may_block_ = !(standard_output && standard_output->IsRegular());
    return;
  }
  if (existing && existing->IsDirectory()) {
    throw UserError(name_, "cannot write", EISDIR);
  }
  if (existing && !existing->IsRegular()) {
    fd_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd_ < 0) {
      const int reason = errno;
      StopIfInterrupted();  // opening a pipe waits for its reader
      throw UserError(name_, "cannot write", reason);
    }
    may_block_ = true;
    return;
  }
  path_ = FollowLinks(path);
  if (existing && access(path_.c_str(), W_OK) != 0) {
    throw UserError(name_, "cannot write", errno);
  }
  OpenTemporary();
  if (existing) fchmod(fd_, existing->mode & 07777);
}

void OutputFile::OpenTemporary() {
  constexpr mode_t kReadWriteForAll = 0666;  // less the umask
  const fs::path folder = fs::path(path_).parent_path();
  if (fs::path(path_).filename().empty()) {
    throw UserError(name_, "cannot write", EISDIR);
  }
  for (int i = 0;; ++i) {
    temporary_ = (folder / fmt::format("{}{}-{}{}", kTemporaryStart, getpid(),
                                       i, kTemporaryEnd))
                     .string();
    if (!kept_.Keep(temporary_.c_str())) {
      temporary_.clear();
      throw UserError(name_, "cannot write", ENAMETOOLONG);
    }
    fd_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
               kReadWriteForAll);
    if (fd_ >= 0) {
      // Tells other runs that it is somebody's, if locks are to be had.
      flock(fd_, LOCK_EX | LOCK_NB);
      return;
    }
    // Not this program's file, or none at all.
    const int reason = errno;
    kept_.Forget();
    if (reason != EEXIST) {
      temporary_.clear();
      throw UserError(name_, "cannot write", reason);
    }
  }
}

OutputFile::~OutputFile() {
  CloseQuietly();
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::CloseQuietly() {
  if (fd_ >= 0 && fd_ != STDOUT_FILENO) close(fd_);
  fd_ = -1;
}

void OutputFile::Write(std::string_view text) {
  while (!text.empty()) {
    std::size_t length = text.size();
    if (may_block_) {
      // A pipe that is ready takes this much without blocking, so that an
      // interruption never has to wait for the reader.
      WaitUntilWritable(fd_);
      length = std::min<std::size_t>(length, PIPE_BUF);
    }
    const ssize_t n = write(fd_, text.data(), length);
    if (n >= 0) {
      text.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno == EAGAIN) {
      WaitUntilWritable(fd_);
    } else if (errno == EPIPE && fd_ == STDOUT_FILENO) {
      throw ReaderGone{};
    } else if (errno != EINTR) {
      throw UserError(name_, "cannot write", errno);
    }
  }
}

void OutputFile::Finish() {
  if (fd_ == STDOUT_FILENO) return;
  // Before the name is given, so that a file of that name is whole even after a
  // power cut; what is no disk need not know how.
  if (!temporary_.empty() && fsync(fd_) != 0 && errno != EINVAL &&
      errno != ENOTSUP && errno != EROFS) {
    throw UserError(name_, "cannot write", errno);
  }
  const int fd = fd_;
  fd_ = -1;
  // Some file systems tell only now that the disk is full.
  if (close(fd) != 0) throw UserError(name_, "cannot write", errno);
}

void OutputFile::Commit() {
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw UserError(name_, "cannot write", errno);
  }
  kept_.Forget();
  temporary_.clear();
}

}  // namespace truelux
