// SPDX-License-Identifier: GPL-3.0-or-later
// MTL files: what emits, and what is wrong with them.

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr const char* kLamp =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n";

Rgb EmissionOf(const std::string& mtl) {
  return SceneFromText(kLamp, mtl).faces()[0].emission;
}

TEST(Material, KeIsTheEmission) {
  EXPECT_EQ(EmissionOf("newmtl lamp\nKe 1 .5 2e3\n"), (Rgb{1, 0.5, 2000}));
  EXPECT_EQ(
      EmissionOf("\tnewmtl lamp\r\n\tKd 1 1 1\r\n  Ke 1 2 3 # bright\r\n"),
      (Rgb{1, 2, 3}));
}

TEST(Material, WithoutKeAFaceOnlyBlocks) {
  EXPECT_EQ(EmissionOf("newmtl lamp\nKd 1 1 1\n"), (Rgb{0, 0, 0}));
}

TEST(Material, TheLastKeWins) {
  EXPECT_EQ(EmissionOf("newmtl lamp\nKe 9 9 9\nKd 1 1 1\nKe 1 2 3\n"),
            (Rgb{1, 2, 3}));
}

TEST(Material, FacesBeforeAnyUsemtlOnlyBlock) {
  const Scene scene = SceneFromText(std::string("f 1 2 3\n").append(kLamp),
                                    "newmtl lamp\nKe 1 2 3\n");
  EXPECT_EQ(scene.faces()[0].emission, (Rgb{0, 0, 0}));
  EXPECT_EQ(scene.faces()[1].emission, (Rgb{1, 2, 3}));
}

TEST(Material, HoldsUntilTheNextUsemtl) {
  const Scene scene = SceneFromText(
      std::string(kLamp).append("f 2 3 1\nusemtl dark\nf 3 1 2\n"),
      "newmtl dark\nnewmtl lamp\nKe 1 2 3\n");
  EXPECT_EQ(scene.faces()[1].emission, (Rgb{1, 2, 3}));
  EXPECT_EQ(scene.faces()[2].emission, (Rgb{0, 0, 0}));
}

TEST(Material, NamesMayHaveBlanksAndHashes) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl my lamp#2 # the second\nf 1 2 3\n",
      "newmtl my lamp#1\nnewmtl my lamp#2\nKe 1 2 3\n");
  EXPECT_EQ(scene.faces()[0].emission, (Rgb{1, 2, 3}));
}

TEST(Material, UsemtlMayStandBeforeMtllib) {
  const Result<Scene> result =
      ReadSceneText(std::string(kLamp).append("mtllib scene.mtl\n"),
                    "newmtl lamp\nKe 1 2 3\n");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value->faces()[0].emission, (Rgb{1, 2, 3}));
}

TEST(Material, AnEmissionMapIsNoted) {
  const Result<Scene> result = ReadSceneText(
      kLamp,
      "newmtl lamp\nKe 1 2 3\nmap_Ke a.png\nmap_Kd b.png\nmap_Ke c.png\n");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.mtl:3: note: map_Ke is ignored, a face emits its Ke "
            "everywhere\n");
}

struct Defect {
  const char* name;
  const char* mtl;
  const char* diagnostic;
};

void PrintTo(const Defect& defect, std::ostream* out) {
  *out << defect.name;
}

class MaterialDefect : public testing::TestWithParam<Defect> {};

TEST_P(MaterialDefect, IsOneLine) {
  const Result<Scene> result = ReadSceneText(kLamp, GetParam().mtl);
  EXPECT_FALSE(result.ok());
  ASSERT_EQ(result.diagnostics.size(), 1U) << TextOf(result.diagnostics);
  const std::string text = result.diagnostics[0].Text();
  const std::string expected = GetParam().diagnostic;
  EXPECT_EQ(text.substr(0, expected.size()), expected) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Mtl, MaterialDefect,
    testing::Values(
        Defect{"Twice", "newmtl lamp\nKe 1 1 1\nnewmtl lamp\nKe 2 2 2\n",
               "scene.mtl:3: error: material 'lamp' is already defined at "
               "scene.mtl:1"},
        Defect{"NegativeKe", "newmtl lamp\nKe 1 -1 1\n",
               "scene.mtl:2: error: Ke is negative, expected numbers >= 0"},
        Defect{"InfiniteKe", "newmtl lamp\nKe 1 1 inf\n",
               "scene.mtl:2: error: 'inf' is no number"},
        Defect{"NanKe", "newmtl lamp\nKe nan 1 1\n",
               "scene.mtl:2: error: 'nan' is no number"},
        Defect{"HugeKe", "newmtl lamp\nKe 1e309 1 1\n",
               "scene.mtl:2: error: '1e309' is too large"},
        Defect{"TwoNumbers", "newmtl lamp\nKe 1 2\n",
               "scene.mtl:2: error: Ke has 2 numbers, expected 3, or 1"},
        Defect{"NoNumber", "newmtl lamp\nKe\n",
               "scene.mtl:2: error: Ke has 0 numbers, expected 3"},
        Defect{"FourNumbers", "newmtl lamp\nKe 1 1 1 1\n",
               "scene.mtl:2: error: Ke has 4 numbers, expected 3"},
        Defect{"Spectral", "newmtl lamp\nKe spectral a.rfl\n",
               "scene.mtl:2: error: Ke spectral is not supported, expected Ke"},
        Defect{"Xyz", "newmtl lamp\nKe xyz 1 1 1\n",
               "scene.mtl:2: error: Ke xyz is not supported, expected Ke r"},
        Defect{"DecimalComma", "newmtl lamp\nKe 1,5 1 1\nKe 2,5 1 1\n",
               "scene.mtl:2: error: decimal commas, expected decimal points"},
        Defect{"OtherMaterial", "newmtl Lamp\nKe 1 1 1\n",
               "scene.obj:4: error: unknown material 'lamp'"}),
    [](const auto& row) { return row.param.name; });

TEST(Material, TwiceInTwoFilesIsADefectToo) {
  const Result<Scene> result = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl b.mtl\n").append(kLamp)},
       {"a.mtl", "newmtl lamp\n"},
       {"b.mtl", "\nnewmtl lamp\nKe 1 1 1\n"}},
      "a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "b.mtl:2: error: material 'lamp' is already defined at a.mtl:1 "
            "with another Ke, expected one definition\n");
}

struct Remark {
  const char* name;
  const char* mtl;
  Rgb emission;
  const char* note;
};

void PrintTo(const Remark& remark, std::ostream* out) {
  *out << remark.name;
}

class MaterialRemark : public testing::TestWithParam<Remark> {};

TEST_P(MaterialRemark, IsANoteAndTheSceneIsRead) {
  const Result<Scene> result = ReadSceneText(kLamp, GetParam().mtl);
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_EQ(result.value->faces()[0].emission, GetParam().emission);
  const std::string note = GetParam().note;
  const std::string text = TextOf(result.diagnostics);
  EXPECT_EQ(text.substr(0, note.size()), note) << text;
  EXPECT_EQ(result.diagnostics.size(), note.empty() ? 0U : 1U) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Mtl, MaterialRemark,
    testing::Values(
        Remark{"OneNumberForAllChannels", "newmtl lamp\nKe 7\n", {7, 7, 7}, ""},
        Remark{"TwiceTheSame",
               "newmtl lamp\nKe 2\nnewmtl lamp\nKe 2 2 2\n",
               {2, 2, 2},
               "scene.mtl:3: note: a material that is defined already is "
               "defined again, with the same Ke"},
        Remark{"WithoutName",
               "newmtl lamp\nKe 1\nnewmtl # x\nKe 9 9 9\n",
               {1, 1, 1},
               "scene.mtl:3: note: newmtl without a name"},
        Remark{"KeBeforeNewmtl",
               "Ke 9 9 9\nnewmtl lamp\nKe 1\n",
               {1, 1, 1},
               "scene.mtl:1: note: Ke before any newmtl"},
        Remark{"DefectOfAnother",
               "newmtl x\nKe no\nnewmtl lamp\nKe 1\n",
               {1, 1, 1},
               "scene.mtl:2: note: 'no' is no number"},
        Remark{"TwiceButNotUsed",
               "newmtl x\nKe 1\nnewmtl x\nKe 2\nnewmtl lamp\nKe 1\n",
               {1, 1, 1},
               "scene.mtl:3: note: material 'x' is already defined"},
        Remark{
            "AnEmitterMayBeClear", "newmtl lamp\nKe 1\nd 0.5\n", {1, 1, 1}, ""},
        Remark{"Clear",
               "newmtl lamp\nd 0.25\n",
               {0, 0, 0},
               "scene.obj:4: note: 1 material that would let light through, "
               "taken as opaque ('lamp', d 0.25)"},
        Remark{"Tr",
               "newmtl lamp\nTr 0.75\n",
               {0, 0, 0},
               "scene.obj:4: note: 1 material that would let light through, "
               "taken as opaque ('lamp', d 0.25)"},
        Remark{"Glass",
               "newmtl lamp\nd 1\nTr 1\nillum 4\n",
               {0, 0, 0},
               "scene.obj:4: note: 1 material that would let light through, "
               "taken as opaque ('lamp', illum 4)"}),
    [](const auto& row) { return row.param.name; });

TEST(Material, OpaqueFromLeavesOutWhatIsClearer) {
  const std::string obj = std::string(kLamp) +
                          "usemtl pane\nf 1 2 3\nf 1 2 3\nusemtl half\n"
                          "f 1 2 3\n";
  const std::string mtl =
      "newmtl lamp\nKe 1\nd 0\nnewmtl pane\nd 0.05\nnewmtl half\nTr 0.5\n";
  ReadOptions options;
  options.opaque_from = 0.5;
  const Result<Scene> result = ReadSceneText(obj, mtl, options);
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:7: note: 2 faces are left out: material 'pane' lets "
            "light through, d 0.05 < 0.5 (line 7, line 8)\n");
  EXPECT_EQ(result.value->facets().size(), 2U);
  EXPECT_EQ(result.value->facets()[1].face, 3);
}

TEST(Material, WithoutDefinitionBlocksIfLenient) {
  const std::string obj = std::string(kLamp) + "usemtl a\nf 1 2 3\nusemtl b\n";
  EXPECT_EQ(TextOf(ReadSceneText(obj).diagnostics),
            "scene.obj:4: error: unknown material 'lamp', expected one that an "
            "MTL file defines (--lenient takes its faces as blockers)\n"
            "scene.obj:6: error: unknown material 'a', expected one that an "
            "MTL file defines (--lenient takes its faces as blockers)\n");
  ReadOptions options;
  options.lenient = true;
  const Result<Scene> result = ReadSceneText(obj, "", options);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:4: note: 2 materials that no MTL file defines: the "
            "faces only block ('lamp', 'a')\n");
}

}  // namespace
}  // namespace truelux
