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
       {"./in/a.mtl", "newmtl lamp\nKe 1\n"}},
      "./in/a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "./in/a.mtl:2: error: Ke has 1 numbers, expected 3\n");
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
            "a.obj:1: error: MTL file 'b.mtl' cannot be read: it does not "
            "exist\n");
}

TEST(ReadScene, AMissingMaterialFileMakesNoMaterialUnknown) {
  const Result<Scene> result = ReadSceneFrom(
      {{"a.obj", std::string("mtllib a.mtl\n").append(kFace)}}, "a.obj");
  EXPECT_EQ(result.diagnostics.size(), 1U) << TextOf(result.diagnostics);
}

TEST(ReadScene, ABinaryMaterialFileIsOneError) {
  const Result<Scene> result =
      ReadSceneFrom({{"a.obj", std::string("mtllib a.mtl\n").append(kFace)},
                     {"a.mtl", std::string("newmtl a\n\1\2\3")}},
                    "a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "a.mtl:2: error: binary data (a byte 1), expected text\n");
}

TEST(ReadScene, AMaterialFileThatIsADirectoryIsOneError) {
  const auto open = [](const std::filesystem::path& path) {
    if (path == "a.obj") {
      return TextFile{TextFile::Status::kRead, "mtllib .\n", ""};
    }
    return ReadTextFile(DataPath(""));
  };
  const Result<Scene> result = ReadSceneWith(open, "a.obj");
  EXPECT_EQ(TextOf(result.diagnostics),
            "a.obj: note: the scene has no faces\n"
            "a.obj:1: error: MTL file '.' cannot be read: Is a directory\n");
}

}  // namespace
}  // namespace truelux
