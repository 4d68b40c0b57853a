// SPDX-License-Identifier: GPL-3.0-or-later
// truelux isolux: files by their endings, notes, refusals.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "support/csv_rows.h"
#include "support/well_formed.h"

namespace truelux::test {
namespace {

using truelux::testing::RowsOf;
using Json = nlohmann::json;

/// A square lamp of side 2, one unit above a floor of side 4.
constexpr std::string_view kLampAndFloor =
    "mtllib square.mtl\n"
    "v -1 -1 1\nv -1 1 1\nv 1 1 1\nv 1 -1 1\n"
    "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\n"
    "usemtl light\no lamp\nf 1 2 3 4\n"
    "usemtl dark\no floor\nf 5 6 7 8\n";
/// A box that stands on the floor, without its bottom.
constexpr std::string_view kBox =
    "v 1 -0.3 0\nv 1.5 -0.3 0\nv 1.5 0.3 0\nv 1 0.3 0\n"
    "v 1 -0.3 0.5\nv 1.5 -0.3 0.5\nv 1.5 0.3 0.5\nv 1 0.3 0.5\n"
    "o box\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n"
    "f 13 14 15 16\n";
/// Two squares that are not in one plane.
constexpr std::string_view kBent =
    "v 9 0 0\nv 9 1 0\nv 9 1 1\no bent\nf 5 6 7 8\nf 9 10 11\n";

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class IsoluxCommandLine : public ::testing::Test {
 protected:
  [[nodiscard]] static Outcome Run(const std::string& scene,
                                   const std::vector<std::string>& words) {
    std::vector<std::string> all = {"isolux", scene,     "--surface",
                                    "floor",  "--chord", "0.05"};
    all.insert(all.end(), words.begin(), words.end());
    return RunTruelux(all);
  }

  TemporaryFolder folder_;
  std::string library_ = folder_.Write(
      "square.mtl", "newmtl light\nKe 1 1 1\nnewmtl dark\nKe 0 0 0\n");
  std::string plain_ = folder_.Write("plain.obj", kLampAndFloor);
  std::string box_ =
      folder_.Write("box.obj", std::string(kLampAndFloor) + std::string(kBox));
};

TEST_F(IsoluxCommandLine, ATableOnStandardOutputByDefault) {
  const Outcome outcome = Run(plain_, {"--levels", "0.2,0.4"});
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const auto rows = RowsOf(outcome.out);
  ASSERT_GT(rows.size(), 20U);
  EXPECT_EQ(rows[0][0], "contour");
  EXPECT_EQ(rows[0][13], "chord");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 14U);
    EXPECT_TRUE(rows[i][1] == "0.2" || rows[i][1] == "0.4");
    EXPECT_EQ(rows[i][2], "1");  // a ring around the lamp
    EXPECT_EQ(rows[i][6], "0");
    EXPECT_EQ(rows[i][11], "1");
  }
  EXPECT_TRUE(Contains(outcome.err, "note: 2 contours at 2 levels, "));
  EXPECT_TRUE(Contains(outcome.err, "all certified within "));
  EXPECT_TRUE(Contains(outcome.err, "no contour of these levels is missing"))
      << outcome.err;
  EXPECT_EQ(Run(plain_, {"--levels", "0.2,0.4", "-o", "-"}).out, outcome.out);
}

// Eval must find E below and above the level at the ends of transversals.
TEST_F(IsoluxCommandLine, EvalAgreesAtTransversals) {
  const auto rows = RowsOf(Run(box_, {"--levels", "0.25"}).out);
  ASSERT_GT(rows.size(), 20U);
  std::ostringstream receivers;
  receivers.precision(17);
  receivers << kHeader;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      for (std::size_t k = 0; k < 3; ++k) {
        receivers << std::stod(rows[i][4 + k]) + side * std::stod(rows[i][7]) *
                                                     std::stod(rows[i][8 + k])
                  << ',';
      }
      receivers << "0,0,1\n";
    }
  }
  const Outcome eval =
      RunTruelux({"eval", box_, folder_.Write("at.csv", receivers.str()),
                  "--on-face", "floor"});
  const auto values = RowsOf(eval.out);
  ASSERT_EQ(values.size(), 2 * rows.size() - 1) << eval.err;
  std::size_t certified = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][11] != "1") continue;
    ++certified;
    const auto value = [&](std::size_t row) {
      const auto column = std::ranges::find(values[0], "E_r");
      return std::stod(
          values[row][static_cast<std::size_t>(column - values[0].begin())]);
    };
    EXPECT_LT(value(2 * i - 1), 0.25) << i;
    EXPECT_GT(value(2 * i), 0.25) << i;
  }
  EXPECT_GT(certified, 20U);
}

TEST_F(IsoluxCommandLine, AllFilesAtOnceWhateverTheThreads) {
  std::vector<std::vector<std::string>> texts;
  for (const char* threads : {"1", "2"}) {
    std::vector<std::string> words = {"--count", "3", "--threads", threads};
    std::vector<std::string>& own = texts.emplace_back();
    const std::vector<std::string> names = {"a.csv", "a.json", "a.svg",
                                            "a.dxf", "a.SVG",  "a.obj",
                                            "a.ply", "a.vtu"};
    for (const std::string& name : names) {
      words.emplace_back("-o");
      words.push_back(folder_ / name);
    }
    words.insert(words.end(), {"--lines", folder_ / "lines.csv"});
    const Outcome outcome = Run(box_, words);
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& name : names)
      own.push_back(ReadFile(folder_ / name));
    own.push_back(ReadFile(folder_ / "lines.csv"));
  }
  EXPECT_EQ(texts[0], texts[1]);
  const Json json = Json::parse(texts[0][1]);
  EXPECT_EQ(json["scene"], "box.obj");
  EXPECT_EQ(json["surface"], "floor");
  EXPECT_EQ(json["channel"], "all");
  EXPECT_EQ(json["levels"].size(), 3U);
  EXPECT_EQ(json["right"], Json({1, 0, 0}));
  EXPECT_EQ(json["up"], Json({0, 1, 0}));
  std::size_t vertices = 0;
  for (const Json& contour : json["contours"])
    vertices += contour["vertices"].size();
  EXPECT_EQ(RowsOf(texts[0][0]).size(), vertices + 1);
  EXPECT_EQ(truelux::testing::MarkupDefect(texts[0][2]), "");
  EXPECT_EQ(texts[0][2], texts[0][4]);
  for (const char* name : {"lamp", "box", "floor"}) {
    EXPECT_EQ(Contains(texts[0][2], "<title>" + std::string(name) + "</title>"),
              name != std::string("floor"))
        << name;
  }
  EXPECT_EQ(truelux::testing::CountOf(texts[0][3], "\nVERTEX\n"), vertices);
  EXPECT_TRUE(texts[0][3].ends_with("\n0\nEOF\n"));
  const std::size_t corners =
      truelux::testing::CountOf("\n" + texts[0][5], "\nv ");
  EXPECT_GT(corners, 100U);
  EXPECT_TRUE(
      Contains(texts[0][6], "element vertex " + std::to_string(corners)));
  EXPECT_TRUE(Contains(texts[0][7],
                       "NumberOfPoints=\"" + std::to_string(corners) + '"'));
  const auto lines = RowsOf(texts[0].back());
  EXPECT_EQ(lines[0].back(), "edges");
  EXPECT_EQ(lines.size(), json["lines"].size() + 1);
  // The box's four walls stand on the floor.
  EXPECT_GE(std::ranges::count_if(
                lines, [](const auto& row) { return row[0] == "jump"; }),
            4);
}

TEST_F(IsoluxCommandLine, AMeshSaysHowWrongItIs) {
  const auto run = [&](const char* error) {
    const Outcome outcome = Run(box_, {"--count", "3", "--mesh-error", error,
                                       "-o", folder_ / "mesh.ply"});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_TRUE(Contains(outcome.err, "note: the mesh has ")) << outcome.err;
    EXPECT_TRUE(
        Contains(outcome.err, "note: interpolation in it was found wrong by "));
    EXPECT_TRUE(Contains(outcome.err, "note: a uniform mesh of "));
    return ReadFile(folder_ / "mesh.ply").size();
  };
  EXPECT_GT(run("0.004"), run("0.03"));
}

TEST_F(IsoluxCommandLine, LinesAlone) {
  const std::string lines = folder_ / "lines.csv";
  const Outcome outcome = Run(box_, {"--count", "0", "--lines", lines});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(Contains(outcome.err, "lines where irradiance may jump, "));
  EXPECT_FALSE(Contains(outcome.err, "contour"));
  EXPECT_GT(RowsOf(ReadFile(lines)).size(), 4U);
}

TEST_F(IsoluxCommandLine, ExtremaAlone) {
  const std::string extrema = folder_ / "extrema.csv";
  const Outcome outcome =
      Run(plain_, {"--count", "0", "--extrema", extrema, "--threads", "2"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(Contains(outcome.err, "1 maximum, 4 minima and 0 saddles"))
      << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, "is proven to be from"));
  const auto rows = RowsOf(ReadFile(extrema));
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"kind", "x", "y", "z", "E", "least",
                                      "most", "radius", "on"}));
  std::size_t maxima = 0;
  for (const auto& row : rows)
    maxima += row[0] == "maximum" ? 1 : 0;
  EXPECT_EQ(maxima, 1U);
  const std::string again = folder_ / "again.csv";
  EXPECT_EQ(Run(plain_, {"--count", "0", "--extrema", again}).exit_status, 0);
  EXPECT_EQ(ReadFile(again), ReadFile(extrema));
}

TEST_F(IsoluxCommandLine, RadianceIsPiTimesAsMuch) {
  const auto most = [&](const char* emission) {
    const std::string file = folder_ / "most.json";
    const Outcome outcome =
        Run(plain_, {"--count", "1", "--emission", emission, "-o", file});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    return Json::parse(ReadFile(file))["most"].get<double>();
  };
  EXPECT_NEAR(most("radiance") / most("exitance"), 3.14159265, 1e-6);
}

TEST_F(IsoluxCommandLine, DarkSurfacesGiveNoContoursButSaySo) {
  const Outcome outcome = RunTruelux({"isolux", box_, "--surface", "lamp"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(RowsOf(outcome.out).size(), 1U);
  EXPECT_TRUE(Contains(outcome.err, "there are no levels to choose"))
      << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, "no light reaches 100 % of the surface"))
      << outcome.err;
}

/// A call that is refused, and a part of what is said.
struct Refusal {
  std::vector<std::string> words;
  std::string message;
};

TEST_F(IsoluxCommandLine, WrongWordsAreRefusedInOneLine) {
  const std::vector<std::string> before = folder_.Names();
  const std::string out = folder_ / "out.csv";
  const std::vector<Refusal> refusals = {
      {{"--levels", "0"}, "--levels: '0' is not a number above 0"},
      {{"--levels", "-1,2"}, "--levels: '-1' is not a number above 0"},
      {{"--levels", "1,nan"}, "--levels: 'nan' is not a number above 0"},
      {{"--levels", "1,,2"}, "--levels: '' is not a number above 0"},
      {{"--levels", ""}, "--levels: '' is not a number above 0"},
      {{"--levels", "2,1"}, "--levels: 1 comes after 2: they must ascend"},
      {{"--levels", "2,2"}, "--levels: 2 comes after 2: they must ascend"},
      {{"--levels", "1", "--count", "3"},
       "--levels and --count say the same: give one of them"},
      {{"--count", "1.5"}, "--count: '1.5' is not a whole number from 0"},
      {{"--count", "-1"}, "--count: '-1' is not a whole number from 0"},
      {{"--count", "0", "--lines", out},
       "--count 0 finds no contours, only --lines"},
      {{"--half-width", "-1e-3"}, "--half-width: '-1e-3' is not a number from"},
      {{"--smallest", "x"}, "--smallest: 'x' is not a number from 0 upwards"},
      {{"--most-triangles", "0"}, "--most-triangles: '0' is not a whole"},
      {{"--mesh-error", "0.1"}, "--mesh-error needs an --output that ends"},
      {{"--mesh-smallest", "1"}, "--mesh-smallest needs an --output that ends"},
      {{"--mesh-vertices", "9"}, "--mesh-vertices needs an --output that ends"},
      {{"--mesh-error", "-1", "-o", folder_ / "a.ply"},
       "--mesh-error: '-1' is not a number from 0"},
      {{"--mesh-vertices", "0", "-o", folder_ / "a.ply"},
       "--mesh-vertices: '0' is not a whole number"},
      {{"--channel", "x"}, "--channel: x not in {luminance,r,g,b}"},
      {{"--threads", "0"}, "--threads: '0' is not a whole number"},
      {{"-o", folder_ / "a.pdf"}, "ends with none of .csv, .json, .svg, .dxf"},
      {{"-o", folder_ / "svg"}, "ends with none of .csv, .json, .svg, .dxf"},
      {{"-o", ""}, "--output: the file name is empty"},
      {{"--lines", "-"}, "--lines: '-' is no file"},
      {{"--extrema", "-"}, "--extrema: '-' is no file"},
      {{"--lines", folder_ / "./out.csv"}, "are the same file"},
      {{"-o", "-", "-o", "-"}, "are the same file"},
      {{"-o", box_}, "is also the input"}};
  for (const Refusal& refusal : refusals) {
    std::vector<std::string> words = refusal.words;
    words.insert(words.end(), {"-o", out});
    const Outcome outcome = Run(box_, words);
    EXPECT_EQ(outcome.exit_status, 2) << refusal.message;
    EXPECT_TRUE(Contains(outcome.err, refusal.message))
        << refusal.message << " in " << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_.Names(), before) << refusal.message;
  }
  const Outcome no_surface = RunTruelux({"isolux", box_, "-o", out});
  EXPECT_EQ(no_surface.exit_status, 2);
  EXPECT_TRUE(Contains(no_surface.err, "--surface is required"));
  const Outcome nothing = Run(box_, {"--count", "0"});
  EXPECT_EQ(nothing.exit_status, 2);
  EXPECT_TRUE(Contains(nothing.err, "nothing to write: --count 0 needs"));
  EXPECT_EQ(folder_.Names(), before);
}

TEST_F(IsoluxCommandLine, SurfacesThatAreNoneAreRefused) {
  const std::string bent = folder_.Write(
      "bent.obj", std::string(kLampAndFloor) + std::string(kBent));
  const std::vector<std::string> before = folder_.Names();
  const std::string out = folder_ / "out.svg";
  const auto refused = [&](const std::string& name, std::string_view message) {
    const Outcome outcome =
        RunTruelux({"isolux", bent, "--surface", name, "-o", out});
    EXPECT_EQ(outcome.exit_status, 2) << name;
    EXPECT_TRUE(Contains(outcome.err, message)) << outcome.err;
    EXPECT_EQ(folder_.Names(), before) << name;
  };
  refused("flor", "error: --surface: no object or group 'flor'");
  refused("bent", "error: --surface: ");
  refused("", "error: --surface: the name is empty");
}

TEST_F(IsoluxCommandLine, HelpFitsAndNamesTheCommand) {
  const Outcome outcome = RunTruelux({"isolux", "--help"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_TRUE(Contains(outcome.out, "Usage: truelux isolux"));
  // Below the options.
  std::istringstream stream(
      outcome.out.substr(outcome.out.find("A vertex comes")));
  for (std::string line; std::getline(stream, line);)
    EXPECT_LE(line.size(), 80U) << line;
  EXPECT_TRUE(Contains(RunTruelux({"--help"}).out, "isolux"));
}

}  // namespace
}  // namespace truelux::test
