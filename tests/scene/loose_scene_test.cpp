// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/loose_scene.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

Vec3<Exact> Step(double x, double y, double z) {
  return {Exact(0x1p-900) * Exact(x), Exact(0x1p-900) * Exact(y),
          Exact(0x1p-900) * Exact(z)};
}

TEST(LooseScene, KeepsVerticesOfTheInputApart) {
  SceneBuilder builder;
  builder.SetVertexNumbers({7, 3, 9});
  builder.AddFace({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  builder.SetVertexNumbers({3, 11, 12});
  builder.AddFace({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const Scene scene = *builder.Build().value;
  EXPECT_EQ(scene.vertices().size(), 4U);
  const LooseScene loose = LooseSceneOf(scene);
  EXPECT_EQ(loose.numbers, (std::vector<int>{3, 7, 9, 11, 12}));
  EXPECT_EQ(loose.scene.vertices().size(), 5U);
  EXPECT_EQ(loose.VertexOf(9).value(), 2);
  EXPECT_FALSE(loose.VertexOf(8).valid());
  // Vertices 9 and 12 are in one place.
  EXPECT_EQ(loose.scene.vertices()[2], loose.scene.vertices()[4]);
}

TEST(LooseScene, EveryTriangleIsAFacetAndFacesKeepTheirNumbers) {
  const Scene scene = MakeScene(
      {{Ceiling(0, 1, 0, 1, 1), kLamp}, {Ceiling(0, 1, 0, 1, 2), kBlack}});
  const LooseScene loose = LooseSceneOf(scene);
  EXPECT_EQ(loose.scene.faces().size(), 2U);
  EXPECT_EQ(loose.scene.facets().size(), 4U);
  EXPECT_EQ(loose.scene.faces()[0].emission, kLamp);
}

// Corner 2 lies between its neighbours: pushed out it is a corner of its own
// triangle, pulled in it is not.
TEST(LooseScene, ADisplacedCornerOf180DegreesChangesTriangles) {
  const Scene scene =
      MakeScene({{{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}}});
  const LooseScene loose = LooseSceneOf(scene);
  const VertexId middle = loose.VertexOf(2);
  const auto out = WithDisplacedTriangles(loose, middle, Step(0, -1, 0));
  const auto in = WithDisplacedTriangles(loose, middle, Step(0, 1, 0));
  const std::size_t before = loose.scene.triangles().size();
  EXPECT_EQ(before, 3U);
  // In one direction the triangles stay what they are.
  ASSERT_NE(out.has_value(), in.has_value());
  EXPECT_EQ((out ? out : in)->triangles().size(), before);
  // A corner that lies on no line with others keeps the triangles.
  EXPECT_FALSE(
      WithDisplacedTriangles(loose, loose.VertexOf(4), Step(0.5, 0.25, 1)));
}

}  // namespace
}  // namespace truelux
