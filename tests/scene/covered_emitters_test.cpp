// SPDX-License-Identifier: GPL-3.0-or-later
// Which emitters are hidden in their own plane: by hand, and against a count of
// the cells that rectangles on a grid have in common.

#include "scene/covered_emitters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/scene_text.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using testing::Floor;
using testing::kLamp;
using testing::MakeScene;
using testing::PortableRandom;
using testing::Ring;
using testing::TestFace;

/// Faces as numbers from 1, each with one that covers it.
std::vector<std::pair<int, int>> CoveredIn(const std::vector<TestFace>& faces) {
  std::vector<std::pair<int, int>> pairs;
  for (const CoveredEmitter& covered :
       CoveredEmittersOf(MakeScene(faces)).found)
    pairs.emplace_back(covered.face + 1, covered.cover + 1);
  return pairs;
}

using Pairs = std::vector<std::pair<int, int>>;

const Ring kSquare = Floor(0, 1, 0, 1, 0);

TEST(CoveredEmitters, TheEarlierOneCovers) {
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {kSquare, kLamp}}), (Pairs{{2, 1}}));
  EXPECT_EQ(CoveredIn({{Floor(0, 4, 0, 4, 0), kLamp},
                       {Floor(1, 2, 1, 2, 0), kLamp},
                       {Floor(3, 9, 3, 9, 0), kLamp},
                       {Floor(8, 10, 8, 10, 0), kLamp}}),
            (Pairs{{2, 1}, {3, 1}, {4, 3}}));
}

TEST(CoveredEmitters, OnlyWhatEmitsCoversOrIsCovered) {
  EXPECT_EQ(CoveredIn({{kSquare}, {kSquare, kLamp}}), Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {kSquare}}), Pairs{});
  EXPECT_EQ(CoveredIn({}), Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}}), Pairs{});
}

TEST(CoveredEmitters, BackToBackTheyDoNot) {
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {testing::Reversed(kSquare), kLamp}}),
            Pairs{});
}

TEST(CoveredEmitters, PlanesAreComparedExactly) {
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {Floor(0, 1, 0, 1, 0x1p-60), kLamp}}),
            Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp},
                       {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0x1p-1000}}, kLamp}}),
            Pairs{});
}

// Borders in common, by a whole edge, by a part of one and by a point.
TEST(CoveredEmitters, BordersDoNotCover) {
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {Floor(1, 2, 0, 1, 0), kLamp}}),
            Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {Floor(1, 2, 0.25, 3, 0), kLamp}}),
            Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp}, {Floor(1, 2, 1, 2, 0), kLamp}}),
            Pairs{});
  EXPECT_EQ(CoveredIn({{kSquare, kLamp},
                       {Floor(1 - 0x1p-50, 2, 1 - 0x1p-50, 2, 0), kLamp}}),
            (Pairs{{2, 1}}));
}

// A concave face and what lies in its notch.
TEST(CoveredEmitters, ANotchIsFree) {
  const Ring angle = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0},
                      {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  EXPECT_EQ(CoveredIn({{angle, kLamp}, {Floor(1, 3, 1, 3, 0), kLamp}}),
            Pairs{});
  EXPECT_EQ(CoveredIn({{angle, kLamp}, {Floor(0.5, 3, 1, 3, 0), kLamp}}),
            (Pairs{{2, 1}}));
}

// Rectangles of whole cells of a grid on a tilted plane x = 2 z.
TEST(CoveredEmitters, AgreeWithTheCellsInCommon) {
  PortableRandom random(77);
  int with = 0;
  int without = 0;
  const int count = testing::SweepSize(400, 4000);
  for (int i = 0; i < count; ++i) {
    std::vector<std::array<int, 4>> cells;
    std::vector<TestFace> faces;
    for (int k = 0; k < 4; ++k) {
      const int a = random.Integer(0, 4);
      const int b = random.Integer(0, 4);
      const int c = a + random.Integer(1, 2);
      const int d = b + random.Integer(1, 2);
      cells.push_back({a, c, b, d});
      Ring ring;
      for (const auto& [u, v] :
           {std::pair(a, b), std::pair(c, b), std::pair(c, d), std::pair(a, d)})
        ring.push_back({2.0 * u, 1.0 * v, 1.0 * u});
      faces.push_back({ring, kLamp});
    }
    std::vector<std::vector<int>> covers(4);
    for (int k = 1; k < 4; ++k) {
      for (int j = 0; j < k; ++j) {
        const auto& p = cells[static_cast<std::size_t>(k)];
        const auto& q = cells[static_cast<std::size_t>(j)];
        if (p[0] < q[1] && q[0] < p[1] && p[2] < q[3] && q[2] < p[3]) {
          covers[static_cast<std::size_t>(k)].push_back(j + 1);
        }
      }
    }
    const Pairs found = CoveredIn(faces);
    std::size_t expected = 0;
    for (const std::vector<int>& of_face : covers)
      expected += of_face.empty() ? 0U : 1U;
    ASSERT_EQ(found.size(), expected) << i;
    for (const auto& [face, cover] : found) {
      const auto& of_face = covers[static_cast<std::size_t>(face - 1)];
      ASSERT_NE(std::ranges::find(of_face, cover), of_face.end()) << i;
    }
    ++(expected == 0 ? without : with);
  }
  EXPECT_GT(with, count / 10);
  EXPECT_GT(without, count / 10);
}

// What overlaps everything in other planes must not take the square of time.
TEST(CoveredEmitters, TheSearchEndsEarlyAndSaysSo) {
  std::vector<TestFace> faces;
  for (int i = 0; i < 4000; ++i) {
    const double z = 0x1p-20 * i;
    faces.push_back({{{0, 0, z}, {9, 0, -z}, {0, 9, 1 - z}}, kLamp});
  }
  const CoveredEmitters covered = CoveredEmittersOf(MakeScene(faces));
  EXPECT_FALSE(covered.is_all);
  EXPECT_TRUE(covered.found.empty());
}

TEST(CoveredEmitters, AFileIsToldOnce) {
  const std::string file =
      "v 0 0 1\nv 0 1 1\nv 1 1 1\nv 1 0 1\nusemtl lamp\n"
      "f 1 2 3 4\nf 1 2 3\nf 2 3 4\n";
  const Result<Scene> scene = ReadSceneText(file, "newmtl lamp\nKe 1 1 1\n");
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(TextOf(scene.diagnostics),
            "scene.obj:7: note: 2 faces that emit are covered, wholly or in "
            "part, by an earlier one in the same plane, which is seen instead "
            "(line 7 by line 6, line 8 by line 6)\n");
}

}  // namespace
}  // namespace truelux
