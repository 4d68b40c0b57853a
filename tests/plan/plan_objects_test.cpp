// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a scene are objects of a plan.

#include "plan/plan_objects.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"

namespace truelux {
namespace {

using testing::MadeFloor;

constexpr Rgb kLight = {0, 0, 1};

/// A rectangle at a height, from its lower left to its upper right corner.
std::vector<Point3> Level(double x, double y, double to_x, double to_y,
                          double z) {
  return {{x, y, z}, {to_x, y, z}, {to_x, to_y, z}, {x, to_y, z}};
}

/// A builder with the floor of MadeFloor(10, 8) in group 1.
SceneBuilder WithFloor() {
  SceneBuilder builder;
  builder.SetGroup("floor");
  builder.AddFace(Level(0, 0, 10, 8, 1));
  return builder;
}

std::vector<PlanObject> ObjectsOf(SceneBuilder& builder, const Isolux& isolux) {
  const Result<Scene> scene = builder.Build();
  EXPECT_TRUE(scene.value.has_value());
  const std::vector<int> floor = {1};
  return PlanObjectsOf(*scene.value, floor, isolux);
}

std::vector<std::string> NamesOf(const std::vector<PlanObject>& objects) {
  std::vector<std::string> names;
  for (const PlanObject& object : objects)
    names.push_back(object.name);
  return names;
}

/// One of each place a face can have, seen from the floor.
SceneBuilder AllAround() {
  SceneBuilder builder = WithFloor();
  builder.SetGroup("table");
  builder.AddFace(Level(1, 1, 2, 2, 1.5));
  builder.AddFace(Level(1, 1, 2, 2, 0.5));
  builder.SetGroup("rug");
  builder.AddFace(Level(3, 3, 4, 4, 1));
  builder.SetGroup("cellar");
  builder.AddFace(Level(0, 0, 10, 8, -1));
  builder.SetGroup("post");
  builder.AddFace({{5, 5, 0}, {6, 5, 0}, {6, 6, 3}, {5, 6, 3}});
  return builder;
}

TEST(PlanObjects, ReachAboveTheSurface) {
  SceneBuilder builder = AllAround();
  const std::vector<PlanObject> objects = ObjectsOf(builder, MadeFloor(10, 8));
  EXPECT_EQ(NamesOf(objects), (std::vector<std::string>{"table", "post"}));
  ASSERT_EQ(objects.size(), 2U);
  ASSERT_EQ(objects[0].faces.size(), 1U);
  EXPECT_EQ(objects[0].faces[0], Level(1, 1, 2, 2, 1.5));
  EXPECT_EQ(objects[1].faces[0].front().z, 0);  // as a whole
}

TEST(PlanObjects, AboveIsTheLitSide) {
  SceneBuilder builder = AllAround();
  Isolux isolux = MadeFloor(10, 8);
  isolux.right = {-1, 0, 0};  // seen from below
  const std::vector<PlanObject> objects = ObjectsOf(builder, isolux);
  EXPECT_EQ(NamesOf(objects),
            (std::vector<std::string>{"table", "cellar", "post"}));
  EXPECT_EQ(objects[0].faces[0], Level(1, 1, 2, 2, 0.5));
}

TEST(PlanObjects, LampsAreApartFromWhatElseHasTheirName) {
  SceneBuilder builder = WithFloor();
  builder.SetGroup("luminaire");
  builder.AddFace(Level(1, 1, 2, 2, 3));
  builder.AddFace(Level(1, 1, 2, 2, 2), kLight);
  builder.SetGroup("");
  builder.AddFace(Level(3, 3, 4, 4, 2), kLight);
  builder.SetGroup("luminaire");
  builder.AddFace(Level(5, 1, 6, 2, 2), kLight);
  const std::vector<PlanObject> objects = ObjectsOf(builder, MadeFloor(10, 8));
  EXPECT_EQ(NamesOf(objects),
            (std::vector<std::string>{"luminaire", "luminaire", ""}));
  EXPECT_FALSE(objects.at(0).emits);
  EXPECT_TRUE(objects.at(1).emits);
  EXPECT_TRUE(objects.at(2).emits);
  EXPECT_EQ(objects.at(0).faces.size(), 1U);
  EXPECT_EQ(objects.at(1).faces.size(), 2U);
}

TEST(PlanObjects, FacesThatAreNotPlanarAreTriangles) {
  SceneBuilder builder = WithFloor();
  builder.SetTwoSided(true);
  builder.SetGroup("flat");
  builder.AddFace(Level(1, 1, 2, 2, 3), kLight);
  builder.SetGroup("bent");
  builder.AddFace({{1, 1, 2}, {2, 1, 2}, {2, 2, 3}, {1, 2, 2}}, kLight);
  const std::vector<PlanObject> objects = ObjectsOf(builder, MadeFloor(10, 8));
  ASSERT_EQ(objects.size(), 2U);
  // Backs are not there a second time.
  ASSERT_EQ(objects[0].faces.size(), 1U);
  EXPECT_EQ(objects[0].faces[0].size(), 4U);
  ASSERT_EQ(objects[1].faces.size(), 2U);
  EXPECT_EQ(objects[1].faces[0].size(), 3U);
}

// The surface itself and what lies in its plane are above it by rounding only.
TEST(PlanObjects, RoundingLiftsNothing) {
  for (int slope = 2; slope < 40; ++slope) {
    const double s = slope;
    SceneBuilder builder;
    builder.SetGroup("roof");
    builder.AddFace({{0, 0, 0}, {3 * s, 0, 3}, {3 * s, 4, 3}, {0, 4, 0}});
    builder.AddFace({{7 * s, 0, 7}, {9 * s, 0, 9}, {9 * s, 4, 9}});
    builder.SetGroup("window");
    builder.AddFace({{s, 5, 1}, {5 * s, 5, 5}, {s, 6, 1}});
    Isolux isolux;
    isolux.size = 10;
    isolux.right = {s / std::hypot(s, 1), 0, 1 / std::hypot(s, 1)};
    isolux.up = {0, 1, 0};
    EXPECT_TRUE(ObjectsOf(builder, isolux).empty()) << slope;
  }
}

TEST(PlanObjects, WithoutASurfaceThereIsNoAbove) {
  SceneBuilder builder = AllAround();
  const Result<Scene> scene = builder.Build();
  ASSERT_TRUE(scene.value.has_value());
  EXPECT_TRUE(PlanObjectsOf(*scene.value, {}, MadeFloor(10, 8)).empty());
  const std::vector<int> floor = {1};
  // No contours were looked for.
  EXPECT_TRUE(PlanObjectsOf(*scene.value, floor, Isolux{}).empty());
}

}  // namespace
}  // namespace truelux
