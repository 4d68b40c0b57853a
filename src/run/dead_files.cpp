// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/dead_files.h"

#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace truelux {
namespace {

namespace fs = std::filesystem;

bool IsTemporary(const std::string& name) {
  return name.starts_with(kTemporaryStart) && name.ends_with(kTemporaryEnd);
}

/// Whether nobody holds the file's lock, and it is not just being made.
bool IsDead(const std::string& path) {
  constexpr std::time_t kYoungSeconds = 60;
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return false;
  struct stat status = {};
  const bool is_dead = fstat(fd, &status) == 0 && S_ISREG(status.st_mode) &&
                       std::time(nullptr) - status.st_mtime > kYoungSeconds &&
                       flock(fd, LOCK_EX | LOCK_NB) == 0;
  close(fd);
  return is_dead;
}

}  // namespace

std::vector<std::string> RemoveDeadFiles(const std::string& folder) {
  std::vector<std::string> removed;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  while (!error && entry != fs::directory_iterator()) {
    const std::string path = entry->path().string();
    if (IsTemporary(entry->path().filename().string()) && IsDead(path) &&
        unlink(path.c_str()) == 0)
      removed.push_back(path);
    entry.increment(error);
  }
  return removed;
}

}  // namespace truelux
