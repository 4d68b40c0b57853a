// SPDX-License-Identifier: GPL-3.0-or-later
// Every defect of an OBJ text is one line: file:line: error: what, expected.

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

/// A statement behind four vertices of a square (lines 1 to 4), one vt and
/// one vn, and how the only diagnostic of it begins. A vertex is used by a face.
struct Defect {
  const char* name;
  const char* statement;
  const char* diagnostic;
};

void PrintTo(const Defect& defect, std::ostream* out) {
  *out << defect.name;
}

class ObjDefect : public testing::TestWithParam<Defect> {};

TEST_P(ObjDefect, IsOneLine) {
  const Defect& defect = GetParam();
  const Result<Scene> result = ReadSceneText(
      std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n")
          .append(defect.statement)
          .append(defect.statement[0] == 'v' ? "\nf 1 2 5\n" : "")
          .append("\nf 1 2 3 4\n"));
  EXPECT_FALSE(result.ok());
  ASSERT_EQ(result.diagnostics.size(), 1U) << TextOf(result.diagnostics);
  const std::string text = result.diagnostics[0].Text();
  const std::string expected =
      std::string("scene.obj:7: error: ").append(defect.diagnostic);
  EXPECT_EQ(text.substr(0, expected.size()), expected) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Indices, ObjDefect,
    testing::Values(
        Defect{"Zero", "f 1 2 0", "vertex index 0, expected 1 or more"},
        Defect{"TooLarge", "f 1 2 5",
               "vertex index 5 is out of range, expected at most 4"},
        Defect{"TooNegative", "f 1 2 -5",
               "vertex index -5 is out of range, expected at least -4"},
        Defect{"Huge", "f 1 2 99999999999999999999",
               "vertex index is out of range, expected at most"},
        Defect{"HugeNegative", "f 1 2 -99999999999999999999",
               "vertex index is out of range, expected at least"},
        Defect{"BeyondInt", "f 1 2 4294967297",
               "vertex index 4294967297 is out of range"},
        Defect{"NoNumber", "f 1 2 x", "'x' is no vertex of a face"},
        Defect{"Fraction", "f 1 2 3.0", "'3.0' is no vertex of a face"},
        Defect{"EmptyVertex", "f 1 2 /1", "'/1' is no vertex of a face"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Numbers, ObjDefect,
    testing::Values(
        Defect{"Nan", "v nan 0 0", "'nan' is no number, expected a finite"},
        Defect{"Inf", "v 0 -inf 0", "'-inf' is no number"},
        Defect{"Overflow", "v 0 0 1e999", "'1e999' is too large"},
        Defect{"Word", "v 0 zero 0", "'zero' is no number"},
        Defect{"Hexadecimal", "v 0x1 0 0", "'0x1' is no number"},
        Defect{"TwoCoordinates", "v 1 2",
               "missing coordinates: v has 2 numbers, expected 3"},
        Defect{"NoCoordinates", "v", "missing coordinates: v has 0 numbers"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Polygons, ObjDefect,
    testing::Values(Defect{"BowTie", "f 1 2 4 3", "no polygon: its edges"},
                    Defect{"TwiceAround", "f 1 2 3 1 2 3",
                           "no polygon: its edges 1-2 and 3-4 meet"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Habits, ObjDefect,
    testing::Values(
        Defect{"DecimalComma", "v 1,5 0 0", "decimal commas, expected decimal"},
        Defect{"CommaBetween", "v 1.5, 0, 0", "commas between numbers"},
        Defect{"ThousandsSeparator", "v 1,234.5 0 0", "thousands separators"},
        Defect{"ThousandsInAFace", "f 1 2 1,003",
               "thousands separators or commas in a face"}),
    [](const auto& row) { return row.param.name; });

TEST(ObjDefects, AreReportedTogetherInTheOrderOfLines) {
  const Result<Scene> result = ReadSceneText(
      "f 1 2 9\nv 0 0 0\nv x 0 0\nv 0 0\nv 1 0 0\nf 1 2 3\nf 0 1 -9\n"
      "usemtl gone\nf 1 1 4 4 1 1 4\n");
  EXPECT_FALSE(result.ok());
  std::vector<int> lines;
  for (const Diagnostic& d : result.diagnostics)
    lines.push_back(d.line);
  EXPECT_EQ(lines, (std::vector<int>{1, 3, 4, 7, 8}))
      << TextOf(result.diagnostics);
}

TEST(ObjDefects, AHabitIsToldOnceAndCounted) {
  std::string text;
  for (int i = 0; i < 300; ++i)
    text += "v " + std::to_string(i) + ",5 0 " + std::to_string(i % 7) + "\n";
  for (int i = 1; i < 299; ++i) {
    text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " +
            std::to_string(i + 2) + "\n";
  }
  EXPECT_EQ(TextOf(ReadSceneText(text).diagnostics),
            "scene.obj:1: error: decimal commas, expected decimal points: "
            "write 1.5, not 1,5 (and no thousands separators) (--lenient "
            "leaves such faces out) (and 299 more such lines)\n");
}

TEST(ObjDefects, OfAllFacesAreNotAlsoNotedAsNoFaces) {
  const Result<Scene> result = ReadSceneText("v 0 0 1\nv 0 1 1\nf 0 1 2\n");
  ASSERT_EQ(result.diagnostics.size(), 1U) << TextOf(result.diagnostics);
  EXPECT_EQ(result.diagnostics[0].line, 3);
}

TEST(ObjDefects, AreCountedBeyondHundred) {
  std::string text;
  for (int i = 0; i < 250; ++i)
    text += "f 1 2 x" + std::to_string(i) + "\n";
  const Result<Scene> result = ReadSceneText(text);
  ASSERT_EQ(result.diagnostics.size(), 101U);
  EXPECT_EQ(result.diagnostics[99].line, 100);
  EXPECT_EQ(result.diagnostics[100].Text(),
            "scene.obj: error: 150 more errors not shown");
}

TEST(ObjDefects, BinaryDataIsOneError) {
  std::string text = "v 0 0 0\nf 1 1";
  text += '\0';
  for (int i = 0; i < 5000; ++i)
    text += static_cast<char>(i * 37 % 256);
  text += "\nf 1 1 1\n";
  const Result<Scene> result = ReadSceneText(text);
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:2: error: binary data (a byte 0), expected text\n");
}

}  // namespace
}  // namespace truelux
