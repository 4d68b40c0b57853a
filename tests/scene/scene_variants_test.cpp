// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_variants.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "scene/emitters.h"

namespace truelux {
namespace {

/// A planar pentagon that emits, a bent quadrangle that emits and is split, a
/// face without area, a black triangle; in two groups.
Scene FourFaces(bool reversed) {
  SceneBuilder builder("four");
  const auto add = [&](std::vector<Point3> ring, const Rgb& emission) {
    if (reversed && emission != Rgb{})
      std::reverse(ring.begin() + 1, ring.end());
    builder.AddFace(ring, emission);
  };
  builder.SetGroup("a");
  add({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 0.5, 0}, {0, 2, 0}}, {1, 2, 3});
  add({{0, 0, 4}, {0, 2, 4}, {2, 2, 5}, {2, 0, 4}}, {0, 0, 1});
  builder.SetGroup("b");
  add({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, {1, 1, 1});
  add({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, {});
  return *builder.Build().value;
}

using Corners = std::array<Point3, 3>;

/// The triangle's corners, the first of them first, in their sense.
Corners CornersOf(const Scene& scene, const Triangle& triangle) {
  Corners corners{};
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] =
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  const auto before = [](const Point3& a, const Point3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  };
  std::rotate(corners.begin(), std::ranges::min_element(corners, before),
              corners.end());
  return corners;
}

TEST(SceneVariants, ReversedEmittersAreWhatTheBuilderMakesOfReversedRings) {
  const Scene variant = WithReversedEmitters(FourFaces(false));
  const Scene expected = FourFaces(true);
  ASSERT_EQ(variant.triangles().size(), expected.triangles().size());
  // Where the fan serves, the same triangles come in another order.
  for (const Triangle& triangle : variant.triangles()) {
    const int face =
        variant.facets()[static_cast<std::size_t>(triangle.facet)].face;
    if (face == 0) continue;
    EXPECT_TRUE(
        std::ranges::any_of(expected.triangles(), [&](const Triangle& other) {
          return CornersOf(expected, other) == CornersOf(variant, triangle);
        }));
  }
  ASSERT_EQ(variant.corners().size(), expected.corners().size());
  for (std::size_t i = 0; i < variant.corners().size(); ++i) {
    const auto point = [i](const Scene& scene) {
      return scene.vertices()[static_cast<std::size_t>(scene.corners()[i])];
    };
    EXPECT_EQ(point(variant), point(expected));
  }
}

TEST(SceneVariants, ReversingTwiceGivesTheSceneBack) {
  const Scene scene = FourFaces(false);
  const Scene twice = WithReversedEmitters(WithReversedEmitters(scene));
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    EXPECT_EQ(twice.triangles()[t].vertices, scene.triangles()[t].vertices);
    EXPECT_EQ(twice.triangles()[t].facet, scene.triangles()[t].facet);
  }
  EXPECT_TRUE(std::ranges::equal(twice.corners(), scene.corners()));
}

TEST(SceneVariants, FacesThatAreRemovedKeepTheNumbersOfTheOthers) {
  const Scene scene = FourFaces(false);
  const Scene variant = WithoutFaces(scene, std::vector<int>{1});
  ASSERT_EQ(variant.faces().size(), 4U);
  EXPECT_EQ(variant.faces()[1].facet_count, 0);
  EXPECT_EQ(variant.faces()[0].facet_count, 1);
  EXPECT_EQ(variant.faces()[3].facet_count, 1);
  EXPECT_EQ(variant.facets().size(), scene.facets().size() - 2);
  for (std::size_t f = 0; f < variant.faces().size(); ++f) {
    const Face& face = variant.faces()[f];
    EXPECT_EQ(face.group, scene.faces()[f].group);
    for (int i = face.first_facet; i < face.first_facet + face.facet_count;
         ++i) {
      const Facet& facet = variant.facets()[static_cast<std::size_t>(i)];
      EXPECT_EQ(facet.face, static_cast<int>(f));
      for (int t = facet.first_triangle;
           t < facet.first_triangle + facet.triangle_count; ++t)
        EXPECT_EQ(variant.triangles()[static_cast<std::size_t>(t)].facet, i);
    }
  }
  EXPECT_TRUE(std::ranges::equal(variant.vertices(), scene.vertices()));
}

TEST(SceneVariants, Emission) {
  const Scene scene = FourFaces(false);
  EXPECT_EQ(WithUnitExitance(scene).faces()[1].emission, (Rgb{1, 1, 1}));
  EXPECT_EQ(WithUnitExitance(scene).faces()[3].emission, Rgb{});
  EXPECT_EQ(EmittersOf(scene), (std::vector<int>{0, 1}));
  EXPECT_EQ(EmittersOf(WithOneEmitter(scene, 1)), std::vector<int>{1});
  EXPECT_EQ(EmittersOf(WithBlackFaces(scene, std::vector<int>{1})),
            std::vector<int>{0});
  EXPECT_FALSE(IsGrey(scene));
  EXPECT_TRUE(IsGrey(WithUnitExitance(scene)));
}

}  // namespace
}  // namespace truelux
