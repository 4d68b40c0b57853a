// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/file_place.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <system_error>
#include <unistd.h>
#ifdef __linux__
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/vfs.h>
#endif

#include "base/ascii_case.h"
#include "run/file_id.h"
#include "run/user_error.h"

namespace truelux {
namespace {

namespace fs = std::filesystem;

fs::path FolderOf(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

#ifdef __linux__

/// A folder of ext4 or f2fs can be told to ignore case; FAT always does.
bool IgnoresCase(const fs::path& folder) {
  const int fd = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return false;
  constexpr long kFat = 0x4D44;
  constexpr long kExFat = 0x2011BAB0;
  struct statfs status = {};
  bool ignores = fstatfs(fd, &status) == 0 &&
                 (status.f_type == kFat || status.f_type == kExFat);
#ifdef FS_CASEFOLD_FL
  int flags = 0;
  if (!ignores && ioctl(fd, FS_IOC_GETFLAGS, &flags) == 0)
    ignores = (flags & FS_CASEFOLD_FL) != 0;
#endif
  close(fd);
  return ignores;
}

#else

bool IgnoresCase([[maybe_unused]] const fs::path& folder) {
#ifdef _PC_CASE_SENSITIVE
  return pathconf(folder.c_str(), _PC_CASE_SENSITIVE) == 0;
#else
  return false;
#endif
}

#endif

}  // namespace

std::string FollowLinks(const std::string& path) {
  constexpr int kMaxLinks = 40;  // as the kernel
  fs::path at = path;
  std::error_code error;
  for (int i = 0; i <= kMaxLinks; ++i) {
    const fs::path target = fs::read_symlink(at, error);
    if (error) return at.string();
    at = at.parent_path() / target;
  }
  throw UserError(path, "cannot write", ELOOP);
}

bool IsSamePlace(const std::string& a, const std::string& b) {
  const fs::path first = FollowLinks(a);
  const fs::path second = FollowLinks(b);
  const auto first_folder = FileIdOf(FolderOf(first).string());
  const auto second_folder = FileIdOf(FolderOf(second).string());
  if (!first_folder || !second_folder || !(*first_folder == *second_folder))
    return false;
  const std::string name = first.filename().string();
  const std::string other = second.filename().string();
  return name == other || (LowerAscii(name) == LowerAscii(other) &&
                           IgnoresCase(FolderOf(first)));
}

}  // namespace truelux
