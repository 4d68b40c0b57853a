// SPDX-License-Identifier: GPL-3.0-or-later
// Objects, groups and rings of a scene.

#include "scene/group_selection.h"

#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr const char* kRoom =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "f 1 2 3\n"           // 1, no name
    "o Table\nf 1 2 4\n"  // 2, Table
    "g top\nf 2 3 4\n"    // 3, Table/top
    "o Shelf\nf 3 4 1\n"  // 4, Shelf/top
    "g Table\nf 1 2 3\n"  // 5, Shelf/Table
    "o Tables\ng t\nf 2 3 1\n";

std::vector<int> FacesNamed(const Scene& scene, std::string_view name) {
  return FacesOf(scene, GroupsNamed(scene, name));
}

TEST(GroupSelection, ANameStandsForObjectsAndGroups) {
  const Scene scene = SceneFromText(kRoom);
  EXPECT_EQ(FacesNamed(scene, "Table"), (std::vector{1, 2, 4}));
  EXPECT_EQ(FacesNamed(scene, "Table/top"), (std::vector{2}));
  EXPECT_EQ(FacesNamed(scene, "top"), (std::vector{2, 3}));
  EXPECT_EQ(FacesNamed(scene, "Shelf"), (std::vector{3, 4}));
  EXPECT_EQ(FacesNamed(scene, "t"), (std::vector{5}));
  EXPECT_EQ(FacesNamed(scene, ""), (std::vector{0}));
  EXPECT_TRUE(GroupsNamed(scene, "able").empty());
  EXPECT_TRUE(GroupsNamed(scene, "Table/").empty());
  EXPECT_TRUE(GroupsNamed(scene, "op").empty());
}

TEST(SceneCorners, AreTheRingsAsTheyWereGiven) {
  SceneBuilder builder;
  // Concave, so that its triangles do not start at its first corner.
  builder.AddFace({{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}});
  builder.AddFace({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});  // without area
  builder.AddFace({{4, 0, 0}, {0, 4, 0}, {0, 0, 9}, {4, 0, 0}});
  const Result<Scene> scene = builder.Build();
  ASSERT_TRUE(scene.ok());
  const auto ring = [&](std::size_t face) {
    std::vector<Point3> points;
    const Face& f = scene.value->faces()[face];
    for (const int corner : scene.value->corners().subspan(
             static_cast<std::size_t>(f.first_corner),
             static_cast<std::size_t>(f.corner_count)))
      points.push_back(
          scene.value->vertices()[static_cast<std::size_t>(corner)]);
    return points;
  };
  EXPECT_EQ(ring(0),
            (std::vector<Point3>{{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(ring(1), (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(ring(2), (std::vector<Point3>{{4, 0, 0}, {0, 4, 0}, {0, 0, 9}}));
  EXPECT_EQ(scene.value->corners().size(), 10U);
}

}  // namespace
}  // namespace truelux
