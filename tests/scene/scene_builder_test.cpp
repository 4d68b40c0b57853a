// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const std::vector<Point3> kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<Point3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Point3> kSaddle{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};

TEST(Scene, IsEmptyByDefault) {
  const Scene scene;
  EXPECT_TRUE(scene.faces().empty());
  EXPECT_TRUE(scene.vertices().empty());
  ASSERT_EQ(scene.group_names().size(), 1U);
  EXPECT_EQ(scene.group_names()[0], "");
}

TEST(SceneBuilder, NumbersFacesFromOne) {
  SceneBuilder builder;
  EXPECT_EQ(builder.AddFace(kTriangle), 1);
  EXPECT_EQ(builder.AddFace({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 2);
  EXPECT_EQ(builder.AddFace(kTriangle, {1, 2, 3}, 9), 3);
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok());
  const auto faces = result.value->faces();
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[1].facet_count, 0);
  EXPECT_EQ(faces[2].facet_count, 1);
  EXPECT_EQ(faces[2].first_facet, 1);
  EXPECT_EQ(faces[2].emission, (Rgb{1, 2, 3}));
  EXPECT_EQ(faces[2].line, 9);
}

TEST(SceneBuilder, APlanarPolygonIsOneFacet) {
  SceneBuilder builder;
  builder.AddFace(kSquare);
  const Scene scene = *builder.Build().value;
  ASSERT_EQ(scene.facets().size(), 1U);
  EXPECT_EQ(scene.facets()[0].triangle_count, 2);
  ASSERT_EQ(scene.triangles().size(), 2U);
  EXPECT_EQ(scene.triangles()[1].facet, 0);
}

TEST(SceneBuilder, AFaceThatIsNotPlanarIsOneFacetATriangle) {
  SceneBuilder builder("s");
  builder.AddFace(kTriangle);
  builder.AddFace(kSaddle, {}, 4);
  builder.AddFace(kSaddle, {}, 5);
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "s:4: note: 2 faces are not planar and are split into triangles, "
            "first at line 4\n");
  const Scene& scene = *result.value;
  ASSERT_EQ(scene.facets().size(), 5U);
  EXPECT_EQ(scene.faces()[1].first_facet, 1);
  EXPECT_EQ(scene.faces()[1].facet_count, 2);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(scene.facets()[i].first_triangle, static_cast<int>(i));
    EXPECT_EQ(scene.facets()[i].triangle_count, 1);
    EXPECT_EQ(scene.triangles()[i].facet, static_cast<int>(i));
  }
  EXPECT_EQ(scene.facets()[3].face, 2);
}

TEST(SceneBuilder, EqualPointsAreOneVertexAndNegativeZeroIsZero) {
  SceneBuilder builder;
  builder.AddFace(kTriangle);
  builder.AddFace({{1, 0, -0.0}, {-0.0, 0, 0}, {0, -1, 0}});
  const Scene scene = *builder.Build().value;
  EXPECT_EQ(scene.vertices().size(), 4U);
  for (const Point3& p : scene.vertices()) {
    EXPECT_FALSE(std::signbit(p.x) || std::signbit(p.z));
  }
  EXPECT_EQ(scene.triangles()[1].vertices[0], scene.triangles()[0].vertices[1]);
  EXPECT_EQ(scene.triangles()[1].vertices[1], scene.triangles()[0].vertices[0]);
}

TEST(SceneBuilder, ConsecutiveDuplicatesOfAFaceAreOneVertex) {
  SceneBuilder builder;
  builder.AddFace(
      {{0, 0, 0}, {0, 0, -0.0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_EQ(result.value->triangles().size(), 1U);
}

TEST(SceneBuilder, FacesWithoutAreaAreNotedOnce) {
  SceneBuilder builder;
  builder.AddFace(kTriangle);
  builder.AddFace({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  builder.AddFace({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}});
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "note: 2 faces without area are ignored, first at face 2\n");
}

TEST(SceneBuilder, NamesTheFaceOfEveryDefect) {
  SceneBuilder builder("s");
  builder.AddFace(kTriangle);
  builder.AddFace({{0, 0, 0}, {1, 0, 0}, {0, kInf, 0}}, {}, 7);
  builder.AddFace(kTriangle, {0, -1, 0});
  builder.AddFace(kTriangle, {0, 0, std::nan("")});
  builder.AddFace({{0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {1, 3, 0}, {3, 3, 0}});
  builder.AddFace({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  const Result<Scene> result = builder.Build();
  EXPECT_FALSE(result.ok());
  ASSERT_EQ(result.diagnostics.size(), 5U) << TextOf(result.diagnostics);
  const auto text = [&](std::size_t i) { return result.diagnostics[i].Text(); };
  EXPECT_EQ(text(0).find("s:7: error: a coordinate is not finite"), 0U);
  EXPECT_EQ(text(1).find("s: error: face 3: the emission is negative"), 0U);
  EXPECT_EQ(text(2).find("s: error: face 4: the emission is negative"), 0U);
  EXPECT_EQ(
      text(3).find("s: error: face 5: no polygon: its edges 2-4 and 5-1 meet"),
      0U)
      << text(3);
  EXPECT_EQ(text(4).find("s: error: face 6: no polygon: its edges"), 0U);
}

TEST(SceneBuilder, LeavesOutWhatIsNoPolygonIfAsked) {
  SceneBuilder builder("s");
  builder.SetLenient(true);
  for (int line = 1; line <= 12; ++line)
    builder.AddFace({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {}, line);
  builder.LeaveOutFace("too ugly");
  builder.AddFace(kTriangle, {1, 2, 3});
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(TextOf(result.diagnostics),
            "s:1: note: 12 faces are left out: no polygon, the boundary "
            "crosses itself (line 1, line 2, line 3, line 4, line 5, line 6, "
            "line 7, line 8, line 9, line 10 and 2 more)\n"
            "s: note: 1 face is left out: too ugly (face 13)\n");
  const Scene& scene = *result.value;
  ASSERT_EQ(scene.faces().size(), 14U);
  EXPECT_EQ(scene.facets().size(), 1U);
  EXPECT_EQ(scene.facets()[0].face, 13);
  ASSERT_EQ(scene.left_out().size(), 2U);
  EXPECT_EQ(scene.left_out()[0].numbers.size(), 12U);
  EXPECT_EQ(scene.left_out()[1].reason, "too ugly");
  EXPECT_EQ(scene.left_out()[1].numbers, std::vector<int>{13});
}

TEST(SceneBuilder, SpikesAreTakenAwayFirst) {
  SceneBuilder builder;
  // A spike out of a corner, and one on a spike.
  builder.AddFace(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {6, 6, 0}, {4, 4, 0}, {0, 4, 0}});
  builder.AddFace({{0, 0, 0},
                   {1, 0, 0},
                   {0, 1, 0},
                   {2, 2, 9},
                   {3, 3, 3},
                   {2, 2, 9},
                   {0, 1, 0}});
  // Nothing but spikes.
  builder.AddFace({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}});
  const Result<Scene> result = builder.Build();
  ASSERT_TRUE(result.ok()) << TextOf(result.diagnostics);
  EXPECT_EQ(TextOf(result.diagnostics),
            "note: 1 face without area is ignored, first at face 3\n");
  EXPECT_EQ(result.value->faces()[0].corner_count, 4);
  EXPECT_EQ(result.value->faces()[1].corner_count, 3);
  EXPECT_EQ(result.value->triangles().size(), 3U);
}

TEST(SceneBuilder, AFaceThatEmitsToBothSidesHasItsFacetsTwice) {
  SceneBuilder builder;
  builder.SetTwoSided(true);
  builder.AddFace(kTriangle, {1, 1, 1});
  builder.AddFace(kTriangle);
  const Scene scene = *builder.Build().value;
  ASSERT_EQ(scene.facets().size(), 3U);
  EXPECT_EQ(scene.faces()[0].facet_count, 2);
  EXPECT_FALSE(scene.facets()[0].is_back);
  EXPECT_TRUE(scene.facets()[1].is_back);
  EXPECT_EQ(scene.facets()[1].face, 0);
  EXPECT_EQ(scene.triangles()[1].vertices[1], scene.triangles()[0].vertices[2]);
  EXPECT_EQ(scene.faces()[1].first_facet, 2);
  EXPECT_FALSE(scene.facets()[2].is_back);
}

TEST(SceneBuilder, GroupsHoldForTheFacesThatFollow) {
  SceneBuilder builder;
  builder.AddFace(kTriangle);
  builder.SetGroup("a");
  builder.AddFace(kTriangle);
  builder.SetGroup("b");
  builder.SetGroup("a");
  builder.AddFace(kTriangle);
  builder.SetGroup("");
  builder.AddFace(kTriangle);
  const Scene scene = *builder.Build().value;
  const auto name = [&](std::size_t face) {
    return scene
        .group_names()[static_cast<std::size_t>(scene.faces()[face].group)];
  };
  EXPECT_EQ(scene.group_names().size(), 3U);
  EXPECT_EQ(name(0), "");
  EXPECT_EQ(name(1), "a");
  EXPECT_EQ(name(2), "a");
  EXPECT_EQ(name(3), "");
}

TEST(SceneBuilder, IsEmptyAfterBuild) {
  SceneBuilder builder("s");
  builder.SetGroup("a");
  builder.AddFace({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_FALSE(builder.Build().ok());
  const Result<Scene> empty = builder.Build();
  ASSERT_TRUE(empty.ok());
  EXPECT_TRUE(empty.value->faces().empty());
  EXPECT_EQ(TextOf(empty.diagnostics), "s: note: the scene has no faces\n");
  EXPECT_EQ(builder.AddFace(kTriangle), 1);
  EXPECT_EQ(builder.Build().value->faces()[0].group, 0);
}

TEST(SceneBuilder, CanBeMoved) {
  SceneBuilder first;
  first.AddFace(kTriangle);
  SceneBuilder second = std::move(first);
  EXPECT_EQ(second.AddFace(kTriangle), 2);
}

}  // namespace
}  // namespace truelux
