// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ files as people have them.

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr std::string_view kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
constexpr std::string_view kNormals = "vn 0 0 1\nvt 0 0\nvt 1 1\n";

Result<Scene> ReadSquare(std::string_view rest) {
  return ReadSceneText(std::string(kCorners).append(kNormals).append(rest));
}

/// The positions of a scene's only facet with one triangle.
std::vector<Point3> TriangleOf(const Scene& scene) {
  std::vector<Point3> points;
  for (const int vertex : scene.triangles()[0].vertices) {
    points.push_back(scene.vertices()[static_cast<std::size_t>(vertex)]);
  }
  return points;
}

const std::vector<Point3> kTriangle{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};

TEST(Obj, FacesMayUseAllFourIndexForms) {
  for (const char* face :
       {"f 1 2 3", "f 1/1 2/2 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/1/1",
        "f -4 -3 -2", "f -4/-2 -3/-1 -2/-2", "f -4//-1 -3//-1 -2//-1",
        "f -4/-2/-1 -3/-1/-1 -2/1/1", "f +1 +2 3"}) {
    const Result<Scene> result = ReadSquare(face);
    ASSERT_TRUE(result.ok()) << face << TextOf(result.diagnostics);
    EXPECT_TRUE(result.diagnostics.empty()) << face;
    EXPECT_EQ(TriangleOf(*result.value), kTriangle) << face;
  }
}

TEST(Obj, NegativeIndicesCountFromTheFace) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(TriangleOf(scene), kTriangle);
  EXPECT_EQ(scene.triangles()[1].vertices[0], scene.triangles()[0].vertices[0]);
  EXPECT_EQ(scene.triangles()[1].vertices[1], scene.triangles()[0].vertices[2]);
}

TEST(Obj, PositiveIndicesMayReferForward) {
  const Scene scene =
      SceneFromText("f 1//1 2//1 3//1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\n");
  EXPECT_EQ(TriangleOf(scene), kTriangle);
}

TEST(Obj, VerticesMayHaveAWeightOrAColour) {
  const Scene scene =
      SceneFromText("v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nf 1 2 3\n");
  EXPECT_EQ(TriangleOf(scene), kTriangle);
}

TEST(Obj, TextureVerticesHaveOneToThreeNumbers) {
  const Result<Scene> result = ReadSquare("vt 1\nvt 1 2\nvt 1 2 3\nf 1 2 3");
  EXPECT_TRUE(result.ok()) << TextOf(result.diagnostics);
}

TEST(Obj, NumbersMayBeWrittenInAnyDecimalForm) {
  const Scene scene =
      SceneFromText("v 1. .5 -1E-3\nv +2 1e0 0\nv 0.1 -0 5e-324\nf 1 2 3\n");
  EXPECT_EQ(
      TriangleOf(scene),
      (std::vector<Point3>{{1, 0.5, -1e-3}, {2, 1, 0}, {0.1, 0, 5e-324}}));
}

TEST(Obj, TabsCarriageReturnsAndAByteOrderMarkAreBlank) {
  const Scene scene = SceneFromText(
      "\xEF\xBB\xBFv\t0 0\t0\r\nv 1 0 0 \r\n\tv 1 1 0\r\n\r\nf  1\t2  3\r\n");
  EXPECT_EQ(TriangleOf(scene), kTriangle);
  EXPECT_EQ(scene.faces()[0].line, 5);
}

TEST(Obj, CommentsAndContinuationsAreUnderstood) {
  const Scene scene = SceneFromText(
      "# c:\\dir\\\nv 0 0 0 # first\nv 1 0 0#second\nv \\\n1 1 0\n"
      "f 1 \\\r\n  2 \\\n  3 # end\nf 1 2 3\n");
  EXPECT_EQ(TriangleOf(scene), kTriangle);
  ASSERT_EQ(scene.faces().size(), 2U);
  EXPECT_EQ(scene.faces()[0].line, 6);
  EXPECT_EQ(scene.faces()[1].line, 9);
}

TEST(Obj, PolygonsMayHaveManyVerticesAndBend) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(scene.facets().size(), 1U);
  EXPECT_EQ(scene.facets()[0].triangle_count, 3);
}

TEST(Obj, UnknownStatementsAreNotedOncePerKind) {
  const Result<Scene> result =
      ReadSquare("l 1 2\nusemap x\nl 2 3\ns off\ns 1\nf 1 2 3\n");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:8: note: statements 'l' are ignored, this is the first\n"
            "scene.obj:9: note: statements 'usemap' are ignored, this is the "
            "first\n");
}

TEST(Obj, ATextWithoutFacesIsAnEmptySceneWithANote) {
  for (const char* text : {"", "\n\n", "# nothing\n", "v 0 0 0\n"}) {
    const Result<Scene> result = ReadSceneText(text);
    ASSERT_TRUE(result.ok()) << text;
    EXPECT_TRUE(result.value->faces().empty());
    EXPECT_EQ(TextOf(result.diagnostics),
              "scene.obj: note: the scene has no faces\n");
  }
}

TEST(Obj, GroupsAreNamedByObjectAndGroup) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\no house\nf 1 2 3\ng roof top\n"
      "f 1 2 3\no\nf 1 2 3\ng\no house\nf 1 2 3\n");
  std::vector<std::string> names;
  for (const Face& face : scene.faces()) {
    names.push_back(scene.group_names()[static_cast<std::size_t>(face.group)]);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"", "house", "house/roof top",
                                             "roof top", "house"}));
  EXPECT_EQ(scene.group_names().size(), 4U);
}

TEST(Obj, NotesCountFacesWithoutAreaAndFacesThatAreNotPlanar) {
  const Result<Scene> result = ReadSceneText(
      "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 2\nf 1 2 3 4\nf 1 1 1\n");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "scene.obj:5: note: 2 faces without area are ignored, first at "
            "line 5\n"
            "scene.obj:6: note: 1 face is not planar and is split into "
            "triangles, first at line 6\n");
  EXPECT_EQ(result.value->faces()[1].facet_count, 2);
}

TEST(Obj, ALargeMeshIsReadWhole) {
  constexpr int kSide = 187;  // 70,000 triangles
  std::string text;
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) {
      text.append("v ").append(std::to_string(i * 0.37));
      text.append(" ").append(std::to_string(j * 0.41));
      text.append(" ").append(std::to_string((i * 7919 + j * 104729) % 1000));
      text.append("\n");
    }
  }
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const std::string a = std::to_string(i * (kSide + 1) + j + 1);
      const std::string b = std::to_string(i * (kSide + 1) + j + 2);
      const std::string c = std::to_string((i + 1) * (kSide + 1) + j + 2);
      const std::string d = std::to_string((i + 1) * (kSide + 1) + j + 1);
      text.append("f ").append(a + " " + b + " " + c + "\n");
      text.append("f ").append(a + " " + c + " " + d + "\n");
    }
  }
  const Scene scene = SceneFromText(text);
  EXPECT_EQ(scene.triangles().size(), 2U * kSide * kSide);
  EXPECT_EQ(scene.vertices().size(), (kSide + 1U) * (kSide + 1U));
}

}  // namespace
}  // namespace truelux
