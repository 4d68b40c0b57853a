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
/// one vn, and how the only diagnostic of it begins.
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
        Defect{"ZeroTexture", "f 1/0 2/1 3/1", "texture vertex index 0"},
        Defect{"ZeroNormal", "f 1//1 2//0 3//1", "normal index 0"},
        Defect{"TooLarge", "f 1 2 5",
               "vertex index 5 is out of range, expected at most 4"},
        Defect{"TooNegative", "f 1 2 -5",
               "vertex index -5 is out of range, expected at least -4"},
        Defect{"TextureTooLarge", "f 1/1 2/2 3/1",
               "texture vertex index 2 is out of range, expected at most 1"},
        Defect{"TextureTooNegative", "f 1/-1 2/-2 3/1",
               "texture vertex index -2 is out of range"},
        Defect{"NormalTooLarge", "f 1//1 2//1 3//7",
               "normal index 7 is out of range, expected at most 1"},
        Defect{"NormalTooNegative", "f 1//1 2//1 3//-2",
               "normal index -2 is out of range"},
        Defect{"Huge", "f 1 2 99999999999999999999",
               "vertex index is out of range, expected at most"},
        Defect{"HugeNegative", "f 1 2 -99999999999999999999",
               "vertex index is out of range, expected at least"},
        Defect{"BeyondInt", "f 1 2 4294967297",
               "vertex index 4294967297 is out of range"},
        Defect{"NoNumber", "f 1 2 x", "'x' is no vertex of a face"},
        Defect{"Fraction", "f 1 2 3.0", "'3.0' is no vertex of a face"},
        Defect{"EmptyVertex", "f 1 2 /1", "'/1' is no vertex of a face"},
        Defect{"EmptyNormal", "f 1 2 3//", "'3//' is no vertex of a face"},
        Defect{"EmptyTexture", "f 1 2 3/", "'3/' is no vertex of a face"},
        Defect{"FourParts", "f 1/1/1/1 2 3", "'1/1/1/1' is no vertex"},
        Defect{"NoIndex", "f", "a face with 0 vertices, expected at least 3"},
        Defect{"TwoIndices", "f 1 2",
               "a face with 2 vertices, expected at least 3"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Numbers, ObjDefect,
    testing::Values(
        Defect{"Nan", "v nan 0 0", "'nan' is no number, expected a finite"},
        Defect{"Inf", "v 0 -inf 0", "'-inf' is no number"},
        Defect{"Overflow", "v 0 0 1e999", "'1e999' is no number"},
        Defect{"Word", "v 0 zero 0", "'zero' is no number"},
        Defect{"Hexadecimal", "v 0x1 0 0", "'0x1' is no number"},
        Defect{"TwoCoordinates", "v 1 2",
               "missing or surplus coordinates: v has 2 numbers, expected 3, 4 "
               "or 6"},
        Defect{"NoCoordinates", "v",
               "missing or surplus coordinates: v has 0 numbers"},
        Defect{"FiveNumbers", "v 1 2 3 4 5",
               "missing or surplus coordinates: v has 5 numbers"},
        Defect{"SevenNumbers", "v 1 2 3 4 5 6 7",
               "missing or surplus coordinates: v has 7 numbers"},
        Defect{"WeightIsNoNumber", "v 1 2 3 w", "'w' is no number"},
        Defect{"ColourIsNoNumber", "v 1 2 3 0 0 nan", "'nan' is no number"},
        Defect{"NormalIsNoNumber", "vn 0 x 1", "'x' is no number"},
        Defect{"NormalOfTwoNumbers", "vn 0 1",
               "missing or surplus coordinates: vn has 2 numbers, expected 3"},
        Defect{"TextureIsNoNumber", "vt 0 inf", "'inf' is no number"},
        Defect{"TextureOfFourNumbers", "vt 0 0 0 0",
               "missing or surplus coordinates: vt has 4 numbers, expected 1 "
               "to 3"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Polygons, ObjDefect,
    testing::Values(Defect{"BowTie", "f 1 2 4 3",
                           "not a simple polygon: its Newell normal is zero"},
                    Defect{"Spike", "f 1 2 3 4 3",
                           "not a simple polygon: its edges 3-4 and 4-5 meet"},
                    Defect{"RepeatedVertex", "f 1 2 3 1 2 3",
                           "not a simple polygon: its edges 1-2 and 3-4 meet"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    References, ObjDefect,
    testing::Values(
        Defect{"UnknownMaterial", "usemtl lamp", "unknown material 'lamp'"},
        Defect{"MaterialWithoutName", "usemtl", "usemtl without a name"},
        Defect{"LibraryWithoutName", "mtllib # none", "mtllib without a name"},
        Defect{"MissingLibrary", "mtllib gone.mtl",
               "MTL file 'gone.mtl' cannot be read: it does not exist"},
        Defect{"MissingLibraryWithBlanks", "mtllib gone far.mtl",
               "MTL file 'gone far.mtl' cannot be read: it does not exist"}),
    [](const auto& row) { return row.param.name; });

TEST(ObjDefects, AreReportedTogetherInTheOrderOfLines) {
  const Result<Scene> result = ReadSceneText(
      "f 1 2 9\nv 0 0 0\nv x 0 0\nv 0 0\nv 1 0 0\nf 1 2 3\nf 0 1 -9\n"
      "usemtl gone\nf 1 4\n");
  EXPECT_FALSE(result.ok());
  std::vector<int> lines;
  for (const Diagnostic& d : result.diagnostics)
    lines.push_back(d.line);
  EXPECT_EQ(lines, (std::vector<int>{1, 3, 4, 7, 7, 8, 9}))
      << TextOf(result.diagnostics);
}

TEST(ObjDefects, OfAllFacesAreNotAlsoNotedAsNoFaces) {
  const Result<Scene> result = ReadSceneText("v 0 0 1\nv 0 1 1\nf 0 1 2\n");
  ASSERT_EQ(result.diagnostics.size(), 1U) << TextOf(result.diagnostics);
  EXPECT_EQ(result.diagnostics[0].line, 3);
}

TEST(ObjDefects, AreCountedBeyondHundred) {
  std::string text;
  for (int i = 0; i < 250; ++i)
    text += "v 0 0\n";
  const Result<Scene> result = ReadSceneText(text);
  ASSERT_EQ(result.diagnostics.size(), 102U);
  EXPECT_EQ(result.diagnostics[0].Text(),
            "scene.obj: note: the scene has no faces");
  EXPECT_EQ(result.diagnostics[100].line, 100);
  EXPECT_EQ(result.diagnostics[101].Text(),
            "scene.obj: error: 150 more errors not shown");
}

TEST(ObjDefects, BinaryDataIsOneError) {
  std::string text = "v 0 0 0\nf 1 1";
  text += '\0';
  for (int i = 0; i < 5000; ++i)
    text += static_cast<char>(i * 37 % 256);
  const Result<Scene> result = ReadSceneText(text);
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:2: error: binary data (a byte 0), expected text\n");
}

}  // namespace
}  // namespace truelux
