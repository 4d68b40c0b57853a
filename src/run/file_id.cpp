// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/file_id.h"

namespace truelux {
namespace {

FileId FromStat(const struct stat& status) {
  return {status.st_dev, status.st_ino, status.st_mode};
}

}  // namespace

std::optional<FileId> FileIdOf(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return FromStat(status);
}

std::optional<FileId> FileIdOf(int fd) {
  struct stat status = {};
  if (fstat(fd, &status) != 0) return std::nullopt;
  return FromStat(status);
}

}  // namespace truelux
