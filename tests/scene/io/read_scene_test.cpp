// SPDX-License-Identifier: GPL-3.0-or-later
// Files: what is found where, and what cannot be read.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr const char* kFace =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n";
constexpr const char* kLamp = "newmtl lamp\nKe 1 2 3\n";

std::string DataPath(const std::string& name) {
  return std::string(TRUELUX_TEST_DATA).append("/scene/").append(name);
}

TEST(ReadScene, ReadsAFileAndItsMaterials) {
  const Result<Scene> result = ReadScene(DataPath("spaces.obj"));
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_TRUE(result.diagnostics.empty()) << TextOf(result.diagnostics);
  const Scene& scene = *result.value;
  ASSERT_EQ(scene.faces().size(), 1U);
  EXPECT_EQ(scene.faces()[0].emission, (Rgb{4, 5, 6}));
  EXPECT_EQ(scene.faces()[0].line, 9);
  EXPECT_EQ(
      scene.group_names()[static_cast<std::size_t>(scene.faces()[0].group)],
      "box/left");
}

TEST(ReadScene, AMissingFileIsOneError) {
  const Result<Scene> result = ReadScene("no/such.obj");
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "no/such.obj: error: cannot be read: No such file or directory\n");
}

TEST(ReadScene, ADirectoryIsOneError) {
  const Result<Scene> result = ReadScene(DataPath(""));
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            DataPath("") + ": error: cannot be read: Is a directory\n");
}

TEST(ReadScene, AFileThatFailsWhileItIsReadIsOneError) {
  const std::filesystem::path unreadable = "/proc/self/mem";
  if (!std::filesystem::exists(unreadable)) {
    GTEST_SKIP() << "only Linux has " << unreadable;
  }
  const Result<Scene> result = ReadScene(unreadable);
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "/proc/self/mem: error: cannot be read: Input/output error\n");
}

TEST(ReadScene, MaterialFilesAreRelativeToTheObj) {
  const Result<Scene> result = ReadSceneFrom(
      {{"in/a.obj", std::string("mtllib sub/a.mtl\n").append(kFace)},
       {"in/sub/a.mtl", kLamp}},
      "in/a.obj");
  EXPECT_TRUE(result.ok()) << TextOf(result.diagnostics);
}

TEST(ReadScene, TheFilesOfASceneAreTold) {
  const SceneAndFiles read = ReadSceneAndFiles(DataPath("spaces.obj"));
  ASSERT_TRUE(read.scene.ok()) << TextOf(read.scene.diagnostics);
  EXPECT_EQ(read.scene.value->faces()[0].emission, (Rgb{4, 5, 6}));
  EXPECT_EQ(read.files,
            (std::vector<std::filesystem::path>{DataPath("spaces.obj"),
                                                DataPath("two words.mtl")}));
  // A file that cannot be read is among them.
  const SceneAndFiles missing = ReadSceneAndFiles("no/such.obj");
  EXPECT_FALSE(missing.scene.ok());
  EXPECT_EQ(missing.files, (std::vector<std::filesystem::path>{"no/such.obj"}));
}

TEST(ReadScene, DefectsOfAMaterialFileNameItAsTheUserWould) {
  const Result<Scene> result = ReadSceneFrom(
      {{"./in/a.obj", std::string("mtllib a.mtl\n").append(kFace)},
       {"./in/a.mtl", "newmtl lamp\nKe 1 2\n"}},
      "./in/a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "./in/a.mtl:2: error: Ke has 2 numbers, expected 3, or 1 for all "
            "channels\n");
}

TEST(ReadScene, SeveralMaterialFilesMayBeNamed) {
  const TextFiles files{
      {"a.obj", std::string("mtllib a.mtl b.mtl\nmtllib c d.mtl\nusemtl b\n"
                            "usemtl cd\n")
                    .append(kFace)},
      {"a.mtl", kLamp},
      {"b.mtl", "newmtl b\n"},
      {"c d.mtl", "newmtl cd\n"}};
  const Result<Scene> result = ReadSceneFrom(files, "a.obj");
  EXPECT_TRUE(result.ok()) << TextOf(result.diagnostics);
}

TEST(ReadScene, AMaterialFileNamedTwiceIsReadOnce) {
  const Result<Scene> result = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl\nmtllib a.mtl\n").append(kFace)},
       {"a.mtl", kLamp}},
      "a.obj");
  EXPECT_TRUE(result.ok()) << TextOf(result.diagnostics);
}

TEST(ReadScene, AMaterialFileSpelledTwoWaysIsReadOnce) {
  const Result<Scene> result = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl\nmtllib ./a.mtl\n").append(kFace)},
       {"a.mtl", kLamp}},
      "a.obj");
  EXPECT_TRUE(result.ok()) << TextOf(result.diagnostics);
}

TEST(ReadScene, OnlyTheMissingOneOfSeveralMaterialFilesIsReported) {
  const Result<Scene> result = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl b.mtl\n").append(kFace)},
       {"a.mtl", kLamp}},
      "a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "a.obj:1: note: MTL file 'b.mtl' does not exist\n");
}

TEST(ReadScene, AMissingMaterialFileMattersIfAMaterialIsUsed) {
  const Result<Scene> used = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl\n").append(kFace)}}, "a.obj");
  EXPECT_EQ(TextOf(used.diagnostics),
            "a.obj:1: note: MTL file 'a.mtl' does not exist\n"
            "a.obj:5: error: unknown material 'lamp', expected one that an MTL "
            "file defines (--lenient takes its faces as blockers)\n");
  const Result<Scene> unused = ReadSceneFrom(
      {{"a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}},
      "a.obj");
  EXPECT_TRUE(unused.ok());
  EXPECT_EQ(TextOf(unused.diagnostics),
            "a.obj:1: note: MTL file 'a.mtl' does not exist\n");
}

TEST(ReadScene, WhatIsNoTextIsSaid) {
  const std::string obj = std::string("mtllib a.mtl\n").append(kFace);
  EXPECT_EQ(TextOf(ReadSceneFrom({{"a.obj", obj},
                                  {"a.mtl", std::string("newmtl a\n\1\2\n3")}},
                                 "a.obj")
                       .diagnostics),
            "a.obj:1: note: MTL file 'a.mtl' cannot be read: binary data (a "
            "byte 1), expected text\n"
            "a.obj:5: error: unknown material 'lamp', expected one that an MTL "
            "file defines (--lenient takes its faces as blockers)\n");
  std::string wide;
  for (const char c : obj)
    wide.append({c, '\0'});
  const std::string says =
      "a.obj: error: looks like UTF-16, expected UTF-8: save it as UTF-8\n";
  EXPECT_EQ(TextOf(ReadSceneFrom({{"a.obj", wide}}, "a.obj").diagnostics),
            says);
  EXPECT_EQ(
      TextOf(
          ReadSceneFrom({{"a.obj", "\xFF\xFE" + wide}}, "a.obj").diagnostics),
      says);
  EXPECT_EQ(
      TextOf(ReadSceneFrom({{"a.obj", std::string("\xFE\xFF\0v", 4)}}, "a.obj")
                 .diagnostics),
      says);
  EXPECT_EQ(TextOf(ReadSceneFrom({{"a.mtl", kLamp}}, "a.mtl").diagnostics),
            "a.mtl: error: this is an MTL file (it has newmtl and neither v "
            "nor f), expected the OBJ file that names it\n");
}

TEST(ReadScene, ControlCharactersBehindTheEndAreIgnored) {
  const std::string obj = std::string("mtllib a.mtl\n").append(kFace);
  const Result<Scene> result =
      ReadSceneFrom({{"a.obj", obj + "\x1A\n" + std::string(100, '\0')},
                     {"a.mtl", std::string(kLamp) + "\x1A"}},
                    "a.obj");
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_TRUE(result.diagnostics.empty());
}

TEST(ReadScene, AMaterialFileThatIsADirectoryIsANote) {
  const auto open = [](const std::filesystem::path& path) {
    if (path == "a.obj") {
      return TextFile{TextFile::Status::kRead, "mtllib .\n", ""};
    }
    return ReadTextFile(DataPath(""));
  };
  const Result<Scene> result = ReadSceneWith({open, ListFolder}, "a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "a.obj: note: the scene has no faces\n"
            "a.obj:1: note: MTL file '.' cannot be read: Is a directory\n");
}

}  // namespace
}  // namespace truelux
