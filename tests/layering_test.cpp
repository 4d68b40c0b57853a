// SPDX-License-Identifier: GPL-3.0-or-later
// Data flows one way: which room of src/ may include which is a table, and no
// files include each other in a circle. Read from the #include lines, so that
// the house cannot drift from its plan (docs/architecture.md).

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxLines = 400;

/// Room -> the rooms whose files it may include, besides itself and the public
/// headers. A room with subfolders is one room.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"exact", {"base"}},
    {"scene", {"base", "exact"}},
    {"visibility", {"base", "exact", "scene"}},
    {"radiometry", {"base", "exact", "scene", "visibility"}},
    {"text", {"base", "scene"}},
    {"run", {"base", "text"}},
    {"explain", {"base", "scene", "visibility", "text"}},
    {"surface", {"base", "exact", "scene", "visibility", "explain"}},
    {"isolux", {"base", "exact", "scene", "run", "surface"}},
    {"isomesh", {"base", "scene", "run", "surface", "isolux"}},
    {"draw", {"base"}},
    {"baselines", {"base", "exact", "scene", "visibility", "radiometry"}},
    {"inspect", {"base", "scene", "visibility", "text", "explain", "draw"}},
    {"compare", {"base", "scene", "visibility", "text", "run", "explain"}},
    {"image",
     {"base", "exact", "scene", "visibility", "text", "run", "explain", "draw",
      "surface", "isolux"}},
    {"gradient", {"base", "text", "run"}},
    {"plan", {"base", "text", "run", "draw"}},
    {"study",
     {"base", "scene", "visibility", "text", "run", "explain", "draw",
      "baselines"}},
    {"cli",
     {"base", "scene", "text", "run", "explain", "draw", "inspect", "compare",
      "gradient", "image", "isolux", "isomesh", "plan", "study", "baselines"}},
};

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

std::string FirstFolderOf(std::string_view path) {
  return std::string(path.substr(0, path.find('/')));
}

/// A header and its .cpp are one node: the path without its ending, and without
/// "src/" or "include/" so that it is spelled as in an #include line.
std::string NodeOf(std::string path) {
  for (const std::string_view root : {"src/", "include/"}) {
    if (path.starts_with(root)) path.erase(0, root.size());
  }
  return path.substr(0, path.rfind('.'));
}

using Graph = std::map<std::string, std::set<std::string>>;

/// Walks a graph depth first and notes a circle, if it meets one.
class CircleFinder {
 public:
  explicit CircleFinder(const Graph& graph) : graph_(graph) {}

  /// Nodes that include each other, one after the other; empty if none do.
  std::vector<std::string> Find() {
    for (const auto& [node, includes] : graph_) {
      if (Visit(node)) return circle_;
    }
    return {};
  }

 private:
  bool Visit(const std::string& node) {
    if (done_.contains(node)) return false;
    const auto start = std::find(path_.begin(), path_.end(), node);
    if (start != path_.end()) {
      circle_.assign(start, path_.end());
      return true;
    }
    path_.push_back(node);
    if (const auto found = graph_.find(node); found != graph_.end()) {
      for (const std::string& next : found->second) {
        if (Visit(next)) return true;
      }
    }
    path_.pop_back();
    done_.insert(node);
    return false;
  }

  const Graph& graph_;
  std::set<std::string> done_;
  std::vector<std::string> path_;
  std::vector<std::string> circle_;
};

TEST(Layering, RoomsIncludeOnlyWhatTheTableAllows) {
  std::size_t checked = 0;
  std::set<std::string> rooms;
  for (const Source& source : SourcesIn("src")) {
    const std::string own = FirstFolderOf(source.path.substr(4));
    rooms.insert(own);
    const auto row = kMayInclude.find(own);
    ASSERT_NE(row, kMayInclude.end()) << source.path << " is in no known room";
    for (const std::string& include : IncludesOf(source)) {
      if (include[0] == '<') continue;
      const std::string other = FirstFolderOf(include.substr(1));
      if (other == own || other == "truelux") continue;
      ++checked;
      EXPECT_TRUE(row->second.contains(other))
          << source.path << " includes " << include.substr(1);
    }
  }
  EXPECT_GT(checked, 200U);
  EXPECT_EQ(rooms.size(), kMayInclude.size());
}

TEST(Layering, TheTableItselfHasNoCircle) {
  EXPECT_EQ(CircleFinder(kMayInclude).Find(), std::vector<std::string>{});
}

TEST(Layering, NoFilesIncludeEachOtherInACircle) {
  Graph graph;
  for (const char* folder : {"src", "include"}) {
    for (const Source& source : SourcesIn(folder)) {
      const std::string node = NodeOf(source.path);
      for (const std::string& include : IncludesOf(source)) {
        if (include[0] == '<') continue;
        const std::string other = NodeOf(include.substr(1));
        if (other != node) graph[node].insert(other);
      }
    }
  }
  EXPECT_GT(graph.size(), 100U);
  EXPECT_EQ(CircleFinder(graph).Find(), std::vector<std::string>{});
}

TEST(Layering, ACircleWouldBeFound) {
  const Graph graph = {{"a", {"b"}}, {"b", {"c", "d"}}, {"d", {"b"}}};
  EXPECT_EQ(CircleFinder(graph).Find(), (std::vector<std::string>{"b", "d"}));
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

TEST(Layering, OneFileSeesTheCommandLineParser) {
  // Its header takes ten seconds to compile.
  std::vector<std::string> users;
  for (const Source& source : SourcesIn("src")) {
    for (const std::string& include : IncludesOf(source)) {
      if (include.starts_with("<CLI/")) users.push_back(source.path);
    }
  }
  EXPECT_EQ(users, std::vector<std::string>{"src/cli/parser.cpp"});
}

TEST(Layering, BindingsUseThePublicHeadersOnly) {
  std::size_t checked = 0;
  for (const Source& source : SourcesIn("bindings")) {
    const fs::path folder = fs::path(source.path).parent_path();
    for (const std::string& include : IncludesOf(source)) {
      if (!include.starts_with("\"")) continue;
      const std::string name = include.substr(1);
      ++checked;
      EXPECT_TRUE(name.starts_with("truelux/") ||
                  fs::exists(fs::path(TRUELUX_SOURCE_DIR) / folder / name))
          << source.path << " includes " << name;
    }
  }
  EXPECT_GT(checked, 20U);
}

TEST(Layering, EveryFileNamesItsLicenceFirst) {
  std::size_t checked = 0;
  for (const char* folder :
       {"include", "src", "tests", "bench", "examples", "fuzz", "bindings"}) {
    for (const Source& source : SourcesIn(folder)) {
      ++checked;
      ASSERT_FALSE(source.lines.empty()) << source.path;
      EXPECT_EQ(source.lines.front(),
                "// SPDX-License-Identifier: GPL-3.0-or-later")
          << source.path;
    }
  }
  EXPECT_GT(checked, 400U);
}

TEST(Layering, FilesAreShortEnoughToRead) {
  for (const char* folder :
       {"include", "src", "tests", "bench", "examples", "fuzz", "bindings"}) {
    for (const Source& source : SourcesIn(folder)) {
      EXPECT_LE(source.lines.size(), kMaxLines) << source.path;
    }
  }
}

/// The name of a type that a line begins to define, or "".
std::string TypeNameIn(std::string_view line) {
  for (const std::string_view word : {"struct ", "enum class ", "class "}) {
    if (!line.starts_with(word)) continue;
    line.remove_prefix(word.size());
    if (line.starts_with("TRUELUX_EXPORT ")) line.remove_prefix(15);
    const std::size_t end = line.find_first_not_of(
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789");
    if (end == line.npos) return std::string(line);
    // A declaration ends at once, a member has its own scope, and a
    // specialization is one more of a template.
    if (line[end] == ';' || line[end] == '<' ||
        line.substr(end).starts_with("::"))
      return "";
    return std::string(line.substr(0, end));
  }
  return "";
}

// Two types of one name in one program share what the compiler makes of them,
// such as their destructors, and no tool says so.
TEST(Layering, NoTwoTypesHaveOneName) {
  std::map<std::string, std::set<std::string>> files;
  for (const char* folder : {"include", "src"}) {
    for (const Source& source : SourcesIn(folder)) {
      bool is_inner = false;  // in a namespace without a name
      for (const std::string& line : source.lines) {
        if (line == "namespace {") is_inner = true;
        if (line == "}  // namespace") is_inner = false;
        const std::string name = is_inner ? "" : TypeNameIn(line);
        if (!name.empty()) files[name].insert(source.path);
      }
    }
  }
  EXPECT_GT(files.size(), 300U);
  EXPECT_TRUE(files.contains("IsoluxContour"));
  for (const auto& [name, paths] : files) {
    EXPECT_EQ(paths.size(), 1U)
        << name << " in " << *paths.begin() << " and " << *paths.rbegin();
  }
}

}  // namespace
}  // namespace truelux
