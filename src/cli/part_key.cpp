// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/part_key.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>

#include "truelux/formulas.h"
#include "truelux/version.h"

#include "run/file_id.h"
#include "run/input_file.h"
#include "run/part_file.h"
#include "run/user_error.h"

namespace truelux {
namespace {

void AddFile(const std::string& path, ContentHash& hash) {
  hash.AddText("file");
  InputFile file(path);
  std::array<char, 1 << 16> piece{};
  while (const std::size_t n = file.Read(piece))
    hash.Add({piece.data(), n});
}

std::string TextOf(const std::optional<double>& number) {
  return number ? fmt::format("{:a}", *number) : "";
}

/// What every command depends on: version, options, and the scene's files.
void AddScene(const OracleOptions& options, const ReadOptions& reading,
              const std::vector<std::filesystem::path>& files,
              ContentHash& hash) {
  const std::vector<std::string> words = {
      std::string(VersionText()),
      std::string(Name(options.method)),
      std::string(Name(options.engine)),
      std::string(Name(options.emission)),
      std::string(Name(options.formula)),
      fmt::format("{:a}", options.half_side),
      reading.lenient ? "lenient" : "",
      reading.two_sided ? "two-sided" : "",
      TextOf(reading.opaque_from)};
  for (const std::string& word : words)
    hash.AddText(word);
  for (const std::filesystem::path& file : files) {
    // Some may have been asked for in vain.
    const auto id = FileIdOf(file.string());
    if (!id || id->IsDirectory()) continue;
    if (!id->IsRegular()) {
      throw UserError(
          "--resume needs a scene in files that can be read again: " +
          file.string() + " is none");
    }
    AddFile(file.string(), hash);
  }
}

}  // namespace

std::string PartKey(const EvalRequest& request,
                    const std::vector<std::filesystem::path>& files) {
  ContentHash hash;
  AddScene(request.options, request.scene.options, files, hash);
  hash.AddText(request.on_face.value_or(""));
  AddFile(request.receivers, hash);
  return hash.Text();
}

std::string PartKey(const RenderRequest& request,
                    const std::vector<std::filesystem::path>& files) {
  ContentHash hash;
  AddScene(request.options, request.scene.options, files, hash);
  for (const std::string& word : request.pixel_words)
    hash.AddText(word);
  return hash.Text();
}

}  // namespace truelux
