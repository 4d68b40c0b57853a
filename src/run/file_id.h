// SPDX-License-Identifier: GPL-3.0-or-later
// Which file a path or a descriptor stands for, links followed.

#ifndef TRUELUX_RUN_FILE_ID_H_
#define TRUELUX_RUN_FILE_ID_H_

#include <optional>
#include <string>
#include <sys/stat.h>

namespace truelux {

/// Two paths name the same file exactly if their ids are equal.
struct FileId {
  dev_t device = 0;
  ino_t inode = 0;
  mode_t mode = 0;

  [[nodiscard]] bool IsRegular() const { return S_ISREG(mode); }

  [[nodiscard]] bool IsDirectory() const { return S_ISDIR(mode); }

  /// A terminal or something like /dev/null: several streams may share it.
  [[nodiscard]] bool IsCharacterDevice() const { return S_ISCHR(mode); }

  friend bool operator==(const FileId& a, const FileId& b) {
    return a.device == b.device && a.inode == b.inode;
  }
};

/// Nothing if there is no such file, or it cannot be looked at.
std::optional<FileId> FileIdOf(const std::string& path);
std::optional<FileId> FileIdOf(int fd);

}  // namespace truelux

#endif  // TRUELUX_RUN_FILE_ID_H_
