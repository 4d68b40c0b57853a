// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_paths.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

#include "run/dead_files.h"
#include "run/file_id.h"
#include "run/file_place.h"
#include "run/messages.h"
#include "run/user_error.h"

namespace truelux {
namespace {

/// A file of the command line: how to call it, and which it is.
struct NamedFile {
  std::string name;
  std::optional<FileId> id;
};

NamedFile Input(const std::string& path) {
  if (path == "-") return {"<stdin>", FileIdOf(STDIN_FILENO)};
  return {path, FileIdOf(path)};
}

NamedFile Output(const OutputPath& output) {
  if (output.path.empty()) return {"<stdout>", FileIdOf(STDOUT_FILENO)};
  return {output.path, FileIdOf(output.path)};
}

/// A terminal or /dev/null may serve several streams at once.
bool IsSameFile(const NamedFile& a, const NamedFile& b) {
  return a.id && b.id && *a.id == *b.id && !a.id->IsCharacterDevice();
}

/// Whether two outputs would end in one place.
bool Collide(const OutputPath& a, const OutputPath& b) {
  const NamedFile first = Output(a);
  const NamedFile second = Output(b);
  if (IsSameFile(first, second)) return true;
  return !first.id && !second.id && !a.path.empty() && !b.path.empty() &&
         IsSamePlace(a.path, b.path);
}

void RemoveDeadFilesBeside(const OutputPaths& outputs) {
  std::set<std::string> folders;
  for (const OutputPath& output : outputs) {
    if (output.path.empty()) continue;
    const auto folder =
        std::filesystem::path(FollowLinks(output.path)).parent_path();
    folders.insert(folder.empty() ? "." : folder.string());
  }
  for (const std::string& folder : folders) {
    for (const std::string& path : RemoveDeadFiles(folder))
      PrintNote(path + " was left by a run that was killed, and is removed");
  }
}

}  // namespace

void CheckInput(const OutputPaths& outputs, const std::string& path) {
  const NamedFile input = Input(path);
  for (const OutputPath& entry : outputs) {
    const NamedFile output = Output(entry);
    // A pipe or socket may well be both ends of a conversation.
    if (IsSameFile(output, input) && output.id->IsRegular()) {
      throw UserError("the output " + output.name + " is also the input " +
                      input.name);
    }
  }
}

void CheckOutputs(const OutputPaths& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!Collide(outputs[k], outputs[i])) continue;
      throw UserError(outputs[i].option + " and " + outputs[k].option +
                      " are the same file: " + Output(outputs[i]).name);
    }
  }
  RemoveDeadFilesBeside(outputs);
}

}  // namespace truelux
