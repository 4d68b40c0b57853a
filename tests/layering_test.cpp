// Data flows one way: a folder of src/ includes only itself and the folders
// before it. Read from the #include lines, so that it cannot drift.

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kLayers = {
    "exact", "scene", "visibility", "radiometry", "report", "baselines", "cli"};

constexpr std::size_t kMaxLines = 400;

struct Source {
  std::string path;  ///< from the root of the repository
  std::vector<std::string> lines;
};

std::vector<Source> SourcesIn(const std::string& folder) {
  const fs::path root = TRUELUX_SOURCE_DIR;
  std::vector<Source> sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    Source source{entry.path().lexically_relative(root).string(), {}};
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      source.lines.push_back(line);
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

/// What stands between the delimiters of the #include lines, the opening one
/// included: "<vector" or "\"exact/sign.h".
std::vector<std::string> IncludesOf(const Source& source) {
  std::vector<std::string> includes;
  for (const std::string& line : source.lines) {
    const std::size_t open = line.find_first_of("<\"");
    if (line.rfind("#include", 0) != 0 || open == line.npos) continue;
    const std::size_t close = line.find_first_of(">\"", open + 1);
    includes.push_back(line.substr(open, close - open));
  }
  return includes;
}

/// The position of a path's first folder among the layers.
std::size_t LayerOf(std::string_view path) {
  const std::string_view folder = path.substr(0, path.find('/'));
  return static_cast<std::size_t>(
      std::find(kLayers.begin(), kLayers.end(), folder) - kLayers.begin());
}

TEST(Layering, FoldersIncludeOnlyThemselvesAndFoldersBefore) {
  std::size_t checked = 0;
  for (const Source& source : SourcesIn("src")) {
    const std::size_t own = LayerOf(source.path.substr(4));
    ASSERT_LT(own, kLayers.size()) << source.path << " is in no known layer";
    for (const std::string& include : IncludesOf(source)) {
      if (include[0] == '<' || include.rfind("\"truelux/", 0) == 0) continue;
      ++checked;
      EXPECT_LE(LayerOf(include.substr(1)), own)
          << source.path << " includes " << include.substr(1);
    }
  }
  EXPECT_GT(checked, 20U);
}

TEST(Layering, PublicHeadersNeedOnlyTheStandardLibrary) {
  const std::vector<Source> headers = SourcesIn("include");
  EXPECT_GT(headers.size(), 5U);
  for (const Source& header : headers) {
    for (const std::string& include : IncludesOf(header)) {
      // Headers of the standard library have neither folder nor ending.
      const bool standard =
          include[0] == '<' && include.find_first_of("/.") == include.npos;
      EXPECT_TRUE(standard || include.rfind("\"truelux/", 0) == 0)
          << header.path << " includes " << include.substr(1);
    }
  }
}

TEST(Layering, FilesAreShortEnoughToRead) {
  for (const char* folder :
       {"include", "src", "tests", "bench", "examples", "fuzz"}) {
    for (const Source& source : SourcesIn(folder)) {
      EXPECT_LE(source.lines.size(), kMaxLines) << source.path;
    }
  }
}

}  // namespace
}  // namespace truelux
