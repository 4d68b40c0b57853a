#include "cli/eval_paths.h"

#include <filesystem>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

#include "cli/file_id.h"
#include "cli/messages.h"
#include "cli/output_file.h"

namespace truelux {
namespace {

namespace fs = std::filesystem;

/// A file of the request: how to call it, and which it is.
struct NamedFile {
  std::string name;
  std::optional<FileId> id;
};

NamedFile Input(const std::string& path) {
  if (path == "-") return {"<stdin>", FileIdOf(STDIN_FILENO)};
  return {path, FileIdOf(path)};
}

/// Where the table goes and, if there is one, the file of --stats.
std::vector<NamedFile> Outputs(const EvalRequest& request) {
  std::vector<NamedFile> outputs;
  if (request.output.empty()) {
    outputs.push_back({"<stdout>", FileIdOf(STDOUT_FILENO)});
  } else {
    outputs.push_back({request.output, FileIdOf(request.output)});
  }
  if (!request.stats.empty()) {
    outputs.push_back({request.stats, FileIdOf(request.stats)});
  }
  return outputs;
}

/// A terminal or /dev/null may serve several streams at once.
bool IsSameFile(const NamedFile& a, const NamedFile& b) {
  return a.id && b.id && *a.id == *b.id && !a.id->IsCharacterDevice();
}

/// Whether two paths will be the same file that does not exist yet.
bool IsSameNewFile(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path first = fs::weakly_canonical(FollowLinks(a), error);
  if (error) return false;
  const fs::path second = fs::weakly_canonical(FollowLinks(b), error);
  return !error && first == second;
}

}  // namespace

void CheckInput(const EvalRequest& request, const std::string& path) {
  const NamedFile input = Input(path);
  for (const NamedFile& output : Outputs(request)) {
    // A pipe or socket may well be both ends of a conversation.
    if (IsSameFile(output, input) && output.id->IsRegular()) {
      throw UserError("the output " + output.name + " is also the input " +
                      input.name);
    }
  }
}

void CheckOutputs(const EvalRequest& request) {
  if (request.stats.empty()) return;
  const std::vector<NamedFile> outputs = Outputs(request);
  const bool both_new = !outputs[0].id && !outputs[1].id;
  if (IsSameFile(outputs[0], outputs[1]) ||
      (both_new && IsSameNewFile(request.output, request.stats))) {
    throw UserError("--stats and --output are the same file: " +
                    outputs[1].name);
  }
}

}  // namespace truelux
