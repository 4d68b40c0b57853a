// SPDX-License-Identifier: GPL-3.0-or-later
// Files as other programs leave them on a disk: each gives the lamp's value, or
// one line that names cause and cure. Lamp: side 2 at height 2, M = 10; straight
// below it E = 10 (4 / pi) (1 / sqrt 5) atan(1 / sqrt 5).

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLampValue =
    "2.394564704607735,2.394564704607735,2.394564704607735\n";
constexpr const char* kVertices = "v -1 -1 2\nv -1 1 2\nv 1 1 2\nv 1 -1 2\n";
constexpr const char* kLampFace = "usemtl lamp\nf 1 2 3 4\n";
constexpr const char* kMaterial = "newmtl lamp\nKe 10 10 10\n";
constexpr const char* kReceiver = "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n";

std::string LampObj(const std::string& library) {
  return "mtllib " + library + "\n" + kVertices + kLampFace;
}

/// The same text in UTF-16.
std::string Wide(std::string_view text, bool is_big, bool has_mark) {
  std::string wide;
  const auto add = [&](char high, char low) {
    wide += is_big ? high : low;
    wide += is_big ? low : high;
  };
  if (has_mark) add('\xFE', '\xFF');
  for (const char c : text)
    add('\0', c);
  return wide;
}

struct Foreign {
  std::string name;
  std::map<std::string, std::string> files;  ///< scene.obj and others
  bool is_read = true;                       ///< else it is an error
  std::string says = {};  ///< a part of standard error; "": it is empty
  std::vector<std::string> options = {};
  std::string table = kReceiver;
  std::string values{kLampValue};
};

void PrintTo(const Foreign& foreign, std::ostream* out) {
  *out << foreign.name;
}

class ForeignFiles : public testing::TestWithParam<Foreign> {};

TEST_P(ForeignFiles, GiveTheValueOrTheReason) {
  const Foreign& foreign = GetParam();
  const TemporaryFolder folder;
  for (const auto& [name, text] : foreign.files) {
    fs::create_directories(fs::path(folder / name).parent_path());
    (void)folder.Write(name, text);
  }
  std::vector<std::string> words = {"eval", folder / "scene.obj",
                                    folder.Write("table", foreign.table)};
  words.insert(words.end(), foreign.options.begin(), foreign.options.end());
  const Outcome outcome = RunTruelux(words);
  EXPECT_EQ(outcome.exit_status, foreign.is_read ? 0 : 2) << outcome.err;
  EXPECT_EQ(outcome.err.empty(), foreign.says.empty()) << outcome.err;
  EXPECT_NE(outcome.err.find(foreign.says), std::string::npos) << outcome.err;
  if (foreign.is_read) {
    EXPECT_TRUE(outcome.out.ends_with(foreign.values)) << outcome.out;
  } else {
    EXPECT_EQ(outcome.out, "");
    // One line for the cause, and the count.
    EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Libraries, ForeignFiles,
    testing::Values(Foreign{"Quotes",
                            {{"scene.obj", LampObj("\"river bridge.mtl\"")},
                             {"river bridge.mtl", kMaterial}}},
                    Foreign{"Blanks",
                            {{"scene.obj", LampObj("river bridge.mtl")},
                             {"river bridge.mtl", kMaterial}}},
                    Foreign{"Backslashes",
                            {{"scene.obj", LampObj(".\\sub\\lamp.mtl")},
                             {"sub/lamp.mtl", kMaterial}},
                            true,
                            "is read for it"},
                    Foreign{"OtherComputer",
                            {{"scene.obj", LampObj("C:\\Users\\a b\\lamp.mtl")},
                             {"lamp.mtl", kMaterial}},
                            true,
                            "is read for it"},
                    Foreign{"LetterCase",
                            {{"scene.obj", LampObj("Scene.MTL")},
                             {"scene.mtl", kMaterial}},
                            true,
                            "is read for it"},
                    Foreign{"Missing",
                            {{"scene.obj", LampObj("nowhere.mtl")}},
                            false,
                            "material 'lamp'"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Texts, ForeignFiles,
    testing::Values(
        Foreign{"WideLittle",
                {{"scene.obj", Wide(LampObj("a.mtl"), false, true)},
                 {"a.mtl", kMaterial}},
                false,
                "UTF-16"},
        Foreign{"WideBig",
                {{"scene.obj", Wide(LampObj("a.mtl"), true, true)},
                 {"a.mtl", kMaterial}},
                false,
                "UTF-16"},
        Foreign{"WideWithoutMark",
                {{"scene.obj", Wide(LampObj("a.mtl"), false, false)},
                 {"a.mtl", kMaterial}},
                false,
                "UTF-16"},
        Foreign{"WideTable",
                {{"scene.obj", LampObj("a.mtl")}, {"a.mtl", kMaterial}},
                false,
                "UTF-16",
                {},
                Wide(kReceiver, false, true)},
        Foreign{"DecimalCommas",
                {{"scene.obj",
                  std::string("v -1,0 -1,0 2,0\nv -1,0 1,0 2,0\nv 1,0 1,0 2,0\n"
                              "v 1,0 -1,0 2,0\nf 1 2 3 4\n")}},
                false,
                "decimal comma"},
        Foreign{
            "ThousandsSeparators",
            {{"scene.obj", std::string(kVertices) + "f 1,001 1,002 1,003\n"}},
            false,
            "thousands separator"},
        Foreign{"AMaterialLibraryAsScene",
                {{"scene.obj", kMaterial}},
                false,
                "MTL"}),
    [](const auto& row) { return row.param.name; });

const std::string kPane = std::string("mtllib a.mtl\n") + kVertices +
                          "v -3 -3 1\nv 3 -3 1\nv 3 3 1\nv -3 3 1\n" +
                          kLampFace + "usemtl glass\nf 5 6 7 8\n";
const std::string kGlass =
    std::string(kMaterial) + "newmtl glass\nd 0.05\nTr 0.95\nillum 4\n";
const std::string kReversed =
    std::string("mtllib a.mtl\n") + kVertices + "usemtl lamp\nf 4 3 2 1\n";

INSTANTIATE_TEST_SUITE_P(
    Zeros, ForeignFiles,
    testing::Values(Foreign{"GlassIsOpaque",
                            {{"scene.obj", kPane}, {"a.mtl", kGlass}},
                            true,
                            "'glass'",
                            {},
                            kReceiver,
                            ",0,0,0\n"},
                    Foreign{"GlassIsLeftOut",
                            {{"scene.obj", kPane}, {"a.mtl", kGlass}},
                            true,
                            "left out",
                            {"--opaque-from", "0.5"}},
                    Foreign{
                        "WoundTheWrongWay",
                        {{"scene.obj", kReversed}, {"a.mtl", kMaterial}},
                        true,
                        "1 of 1 emitters shows its back (wound the wrong way?",
                        {},
                        kReceiver,
                        ",0,0,0\n"},
                    Foreign{"TwoSided",
                            {{"scene.obj", kReversed}, {"a.mtl", kMaterial}},
                            true,
                            "",
                            {"--two-sided"}}),
    [](const auto& row) { return row.param.name; });

/// The lamp with its receiver in another table.
Foreign Table(const std::string& name, const std::string& table,
              const std::string& values, const std::string& says = "") {
  return {name,  {{"scene.obj", LampObj("a.mtl")}, {"a.mtl", kMaterial}},
          true,  says,
          {},    table,
          values};
}

const std::string kSemicolons =
    "2.394564704607735;2.394564704607735;2.394564704607735\n";

INSTANTIATE_TEST_SUITE_P(
    Tables, ForeignFiles,
    testing::Values(
        Table("Semicolons", "x;y;z;nx;ny;nz\n0;0;0;0;0;1\n", kSemicolons),
        Table("SepLine", "sep=;\nx;y;z;nx;ny;nz\n0;0;0;0;0;1\n", kSemicolons),
        Table("Tabs", "x\ty\tz\tnx\tny\tnz\n0\t0\t0\t0\t0\t1\n",
              "2.394564704607735\t2.394564704607735\t2.394564704607735\n"),
        Table("UpperCase", "X,Y,Z,NX,NY,NZ\n0,0,0,0,0,1\n",
              std::string(kLampValue)),
        Table("Comment", "# by a program\nx,y,z,nx,ny,nz\n0,0,0,0,0,1\n",
              std::string(kLampValue)),
        Table("NoHeader", "0 0 0 0 0 1\n",
              "2.394564704607735 2.394564704607735 2.394564704607735\n",
              "have no header"),
        Foreign{"DecimalCommas",
                {{"scene.obj", LampObj("a.mtl")}, {"a.mtl", kMaterial}},
                false,
                "decimal comma",
                {},
                "x;y;z;nx;ny;nz\n0,0;0;0;0;0;1\n0,5;0;0;0;0;1\n"}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace truelux::test
