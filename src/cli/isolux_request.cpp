// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/isolux_request.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string_view>

#include "truelux/io.h"

#include "base/ascii_case.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "run/interrupt.h"
#include "run/user_error.h"
#include "text/csv.h"

namespace truelux {
namespace {

/// Standard output gets a table.
PlanFormat FormatOf(const std::string& path) {
  if (path.empty()) return PlanFormat::kCsv;
  const std::string ending =
      LowerAscii(std::filesystem::path(path).extension().string());

  struct Ending {
    std::string_view text;
    PlanFormat format;
  };

  constexpr std::array<Ending, 7> kEndings = {{{".csv", PlanFormat::kCsv},
                                               {".json", PlanFormat::kJson},
                                               {".svg", PlanFormat::kSvg},
                                               {".dxf", PlanFormat::kDxf},
                                               {".obj", PlanFormat::kObj},
                                               {".ply", PlanFormat::kPly},
                                               {".vtu", PlanFormat::kVtu}}};
  for (const Ending& known : kEndings) {
    if (known.text == ending) return known.format;
  }
  throw UsageError(fmt::format(
      "--output: '{}' ends with none of .csv, .json, .svg, .dxf, .obj, .ply "
      "and .vtu",
      path));
}

void ParseOutputs(const IsoluxArguments& arguments, IsoluxRequest& request) {
  for (const std::string& word : arguments.outputs) {
    std::string path = PathValue("--output", word);
    if (path == "-") path.clear();
    request.formats.push_back(FormatOf(path));
    request.outputs.push_back({"--output", path});
  }
  request.has_mesh = std::ranges::any_of(request.formats, IsOfMesh);
  if (!request.has_contours && !request.formats.empty()) {
    throw UsageError(
        "--count 0 finds no contours, only --lines and --extrema: --output has "
        "nothing to write");
  }
  if (request.formats.empty() && request.has_contours) {
    request.formats.push_back(PlanFormat::kCsv);
    request.outputs.push_back({"--output", ""});
  }
  const std::string lines = PathValue("--lines", arguments.lines);
  if (lines == "-") throw UsageError("--lines: '-' is no file");
  request.has_lines = !lines.empty();
  if (request.has_lines) request.outputs.push_back({"--lines", lines});
  const std::string extrema = PathValue("--extrema", arguments.extrema);
  if (extrema == "-") throw UsageError("--extrema: '-' is no file");
  request.has_extrema = !extrema.empty();
  if (request.has_extrema) request.outputs.push_back({"--extrema", extrema});
  if (request.outputs.empty()) {
    throw UsageError("nothing to write: --count 0 needs --lines or --extrema");
  }
}

std::vector<double> ParseLevels(std::string_view words) {
  std::vector<double> levels;
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t comma = std::min(words.find(',', at), words.size());
    const std::string word(TrimBlanks(words.substr(at, comma - at)));
    const std::optional<double> level = ParseNumber(word);
    if (!level || !(*level > 0)) {
      throw UsageError(
          fmt::format("--levels: '{}' is not a number above 0", word));
    }
    if (!levels.empty() && !(*level > levels.back())) {
      throw UsageError(
          fmt::format("--levels: {} comes after {}: they must ascend", word,
                      levels.back()));
    }
    levels.push_back(*level);
    at = comma + 1;
  }
  return levels;
}

void ParseWishes(const IsoluxArguments& arguments, IsoluxRequest& request) {
  constexpr std::int64_t kMostLevels = 10000;
  constexpr std::int64_t kMostTriangles = 1'000'000'000;
  IsoluxOptions& wishes = request.wishes;
  if (arguments.levels && arguments.count)
    throw UsageError("--levels and --count say the same: give one of them");
  if (arguments.levels) wishes.levels = ParseLevels(*arguments.levels);
  if (arguments.count) {
    wishes.count = static_cast<int>(
        WholeNumberValue("--count", *arguments.count, 0, kMostLevels));
    request.has_contours = wishes.count > 0;
  }
  for (const ScalarChannel channel :
       {ScalarChannel::kLuminance, ScalarChannel::kRed, ScalarChannel::kGreen,
        ScalarChannel::kBlue}) {
    if (arguments.channel && *arguments.channel == Name(channel))
      wishes.channel = channel;
  }
  wishes.chord = SizeValue("--chord", arguments.chord);
  wishes.half_width = SizeValue("--half-width", arguments.half_width);
  wishes.smallest = SizeValue("--smallest", arguments.smallest);
  if (arguments.most_triangles) {
    wishes.most_triangles = static_cast<std::size_t>(WholeNumberValue(
        "--most-triangles", *arguments.most_triangles, 1, kMostTriangles));
  }
}

void ParseMeshWishes(const IsoluxArguments& arguments, IsoluxRequest& request) {
  constexpr std::int64_t kMostVertices = 1'000'000'000;

  struct Given {
    const char* name;
    const std::optional<std::string>& word;
  };

  const Given error = {"--mesh-error", arguments.mesh_error};
  const Given smallest = {"--mesh-smallest", arguments.mesh_smallest};
  const Given vertices = {"--mesh-vertices", arguments.mesh_vertices};
  for (const Given& given : {error, smallest, vertices}) {
    if (given.word && !request.has_mesh) {
      throw UsageError(
          fmt::format("{} needs an --output that ends with .obj, .ply or .vtu",
                      given.name));
    }
  }
  IsoMeshOptions& wishes = request.mesh_wishes;
  if (error.word) wishes.error = SizeValue(error.name, *error.word);
  if (smallest.word) wishes.smallest = SizeValue(smallest.name, *smallest.word);
  if (vertices.word) {
    wishes.most_vertices = static_cast<std::size_t>(
        WholeNumberValue(vertices.name, *vertices.word, 1, kMostVertices));
  }
}

}  // namespace

IsoluxRequest ParseIsoluxRequest(const IsoluxArguments& arguments) {
  IsoluxRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  if (arguments.surface.empty())
    throw UsageError("--surface: the name is empty");
  request.surface = arguments.surface;
  ParseWishes(arguments, request);
  ParseOutputs(arguments, request);
  ParseMeshWishes(arguments, request);
  request.options.method = MethodOf(arguments.method);
  request.options.emission = EmissionOf(arguments.emission);
  request.options.stop = InterruptFlag();
  request.wishes.threads = ThreadsOf(arguments.threads);
  return request;
}

}  // namespace truelux
