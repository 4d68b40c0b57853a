// SPDX-License-Identifier: GPL-3.0-or-later
// Which emitters have their chain in common: facets of exactly one plane that
// share edges and overlap none that emits.

#include "visibility/edges/emitter_groups.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/index/scene_index.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Rgb kOther{3, 1, 0.5};

/// The group sizes of a scene, and of each how many emissions it has.
std::vector<std::pair<std::size_t, std::size_t>> SizesOf(
    const std::vector<TestFace>& faces) {
  const Scene scene = MakeScene(faces);
  std::vector<std::pair<std::size_t, std::size_t>> sizes;
  for (const EmitterGroup& group :
       EmitterGroupsOf(scene, SceneIndex::Of(scene).pieces())) {
    EXPECT_EQ(group.alike_ends.back(), group.facets.size());
    sizes.emplace_back(group.facets.size(), group.alike_ends.size());
  }
  return sizes;
}

using Sizes = std::vector<std::pair<std::size_t, std::size_t>>;

/// Cells of a lamp that is cut in columns and rows.
std::vector<TestFace> Grid(int columns, int rows) {
  std::vector<TestFace> faces;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k)
      faces.push_back({Ceiling(i, i + 1, k, k + 1, 2), kLamp});
  }
  return faces;
}

TEST(EmitterGroups, ACutLampIsOne) {
  EXPECT_EQ(SizesOf(Grid(3, 2)), (Sizes{{6, 1}}));
  EXPECT_EQ(SizesOf(Grid(1, 1)), Sizes{});
}

TEST(EmitterGroups, ThoseThatEmitTheSameAreConsecutive) {
  std::vector<TestFace> faces = Grid(3, 1);
  faces[1].emission = kOther;
  const Scene scene = MakeScene(faces);
  const auto groups = EmitterGroupsOf(scene, SceneIndex::Of(scene).pieces());
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].facets,
            (std::vector{FacetId(0), FacetId(2), FacetId(1)}));
  EXPECT_EQ(groups[0].alike_ends, (std::vector<std::size_t>{2, 3}));
}

TEST(EmitterGroups, WhatDoesNotEmitIsNoMember) {
  std::vector<TestFace> faces = Grid(3, 1);
  faces[1].emission = kBlack;
  EXPECT_EQ(SizesOf(faces), Sizes{});
}

TEST(EmitterGroups, WhatLooksTheOtherWayIsNoMember) {
  std::vector<TestFace> faces = Grid(3, 1);
  faces[2].ring = Reversed(faces[2].ring);
  EXPECT_EQ(SizesOf(faces), (Sizes{{2, 1}}));
  // Folded back onto its neighbour: it runs through the common edge in the
  // opposite direction, but looks away.
  faces = Grid(2, 1);
  faces.push_back({{{2, 1, 2}, {2, 0, 2}, {1.5, 0.5, 2}}, kLamp});
  faces[2].ring = Reversed(faces[2].ring);
  EXPECT_EQ(SizesOf(faces).size(), 1U);
}

TEST(EmitterGroups, ANeighbourInAnotherPlaneIsNoMember) {
  std::vector<TestFace> faces = Grid(2, 1);
  faces.push_back({{{2, 0, 2}, {2, 1, 2}, {3, 1, 2.5}, {3, 0, 2.5}}, kLamp});
  EXPECT_EQ(SizesOf(faces), (Sizes{{2, 1}}));
  // One unit in the last place is another plane.
  faces = Grid(2, 1);
  const double up = std::nextafter(2.0, 3.0);
  faces[1].ring = {{1, 0, 2}, {1, 1, 2}, {2, 1, up}, {2, 0, up}};
  EXPECT_EQ(SizesOf(faces), Sizes{});
}

TEST(EmitterGroups, WhatOverlapsAnEmitterIsNoMember) {
  // The third overlaps the second and shares no edge.
  std::vector<TestFace> faces = Grid(3, 1);
  faces.push_back({Ceiling(1.25, 1.75, 0.25, 0.75, 2), kOther});
  EXPECT_EQ(SizesOf(faces), (Sizes{{2, 1}}));
  // It touches the second in a corner and along a piece of an edge alone.
  faces.back().ring = Ceiling(1.25, 1.75, 1, 1.5, 2);
  EXPECT_EQ(SizesOf(faces), (Sizes{{3, 1}}));
  // The same place twice: neither is one.
  faces = Grid(2, 1);
  faces.push_back(faces[0]);
  EXPECT_EQ(SizesOf(faces), Sizes{});
  // What does not emit may lie over it.
  faces.back().emission = kBlack;
  EXPECT_EQ(SizesOf(faces), (Sizes{{2, 1}}));
}

TEST(EmitterGroups, LampsApartAreGroupsOfTheirOwn) {
  std::vector<TestFace> faces = Grid(2, 1);
  for (const TestFace& face : Grid(2, 1)) {
    faces.push_back(face);
    for (Point3& p : faces.back().ring)
      p.x += 10;
  }
  EXPECT_EQ(SizesOf(faces), (Sizes{{2, 1}, {2, 1}}));
}

}  // namespace
}  // namespace truelux
