// SPDX-License-Identifier: GPL-3.0-or-later
// Names of MTL files as exporters write them.

#include "scene/io/library_search.h"

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

using Names = std::vector<std::string>;

TEST(LibraryReadings, AreTheLikeliestFirst) {
  EXPECT_EQ(LibraryReadings("a.mtl"), (std::vector<Names>{{"a.mtl"}}));
  EXPECT_EQ(
      LibraryReadings("\"a b.mtl\""),
      (std::vector<Names>{{"\"a b.mtl\""}, {"a b.mtl"}, {"\"a", "b.mtl\""}}));
  EXPECT_EQ(LibraryReadings("a\\ b.mtl"),
            (std::vector<Names>{{"a\\ b.mtl"}, {"a b.mtl"}, {"a\\", "b.mtl"}}));
  EXPECT_EQ(LibraryReadings("one two.mtl b.MTL"),
            (std::vector<Names>{{"one two.mtl b.MTL"},
                                {"one", "two.mtl", "b.MTL"},
                                {"one two.mtl", "b.MTL"}}));
}

/// A mtllib line, the files that are there, and what is told.
struct Line {
  const char* name;
  const char* line;
  Names files;
  const char* notes;
};

void PrintTo(const Line& line, std::ostream* out) {
  *out << line.name;
}

class MtllibLine : public testing::TestWithParam<Line> {};

TEST_P(MtllibLine, FindsItsFiles) {
  const Line& line = GetParam();
  TextFiles files{
      {"in/a.obj", std::string("mtllib ").append(line.line).append("\n")}};
  int material = 0;
  for (const std::string& file : line.files) {
    const std::string height = std::to_string(material);
    const std::string name = "m" + std::to_string(material++);
    files["in/" + file] = "newmtl " + name + "\nKe 1\n";
    files["in/a.obj"] += "v 0 0 " + height + "\nv 1 0 " + height + "\nv 0 1 " +
                         height + "\nusemtl " + name + "\nf -3 -2 -1\n";
  }
  const Result<Scene> result = ReadSceneFrom(files, "in/a.obj");
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics), line.notes);
}

INSTANTIATE_TEST_SUITE_P(
    Lines, MtllibLine,
    testing::Values(
        Line{"Quoted", "\"a b.mtl\"", {"a b.mtl"}, ""},
        Line{"EscapedBlank", "a\\ b.mtl", {"a b.mtl"}, ""},
        Line{"Whole", "a b.mtl", {"a b.mtl"}, ""},
        Line{"Split", "a.mtl b.mtl", {"a.mtl", "b.mtl"}, ""},
        Line{"SplitQuoted", "\"a.mtl\" \"b.mtl\"", {"a.mtl", "b.mtl"}, ""},
        Line{"SplitAfterEndings",
             "one two.mtl three.mtl",
             {"one two.mtl", "three.mtl"},
             ""},
        Line{"Backslash",
             ".\\sub\\a.mtl",
             {"sub/a.mtl"},
             "in/a.obj:1: note: MTL file '.\\sub\\a.mtl' does not exist by "
             "this name; 'in/sub/a.mtl' is read for it\n"},
        Line{"OtherCase",
             "Sub/A.MTL",
             {"sub/a.mtl"},
             "in/a.obj:1: note: MTL file 'Sub/A.MTL' does not exist by this "
             "name; 'in/sub/a.mtl' is read for it\n"},
        Line{"AnotherMachine",
             "C:\\Users\\me\\a.mtl",
             {"a.mtl"},
             "in/a.obj:1: note: MTL file 'C:\\Users\\me\\a.mtl' does not exist "
             "by this name; 'in/a.mtl' is read for it\n"},
        Line{"AnotherMachineAndCase",
             "/home/me/A.mtl",
             {"a.mtl"},
             "in/a.obj:1: note: MTL file '/home/me/A.mtl' does not exist by "
             "this name; 'in/a.mtl' is read for it\n"},
        Line{"OneOfTwo",
             "a.mtl gone.mtl",
             {"a.mtl"},
             "in/a.obj:1: note: MTL file 'gone.mtl' does not exist\n"},
        Line{"None",
             "gone far.mtl",
             {},
             "in/a.obj: note: the scene has no faces\n"
             "in/a.obj:1: note: MTL file 'gone far.mtl' does not exist\n"}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace truelux
