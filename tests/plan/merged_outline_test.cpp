// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of polygons together: they fill the same, and inner sides are gone.

#include "plan/merged_outline.h"

#include <cstddef>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

std::vector<GridRing> Merged(const std::vector<GridRing>& rings) {
  MergedOutline outline;
  for (const GridRing& ring : rings)
    outline.Add(ring);
  return outline.Rings();
}

/// How often a ring winds around (x + 0.37, y + 0.5), which is on no side: its
/// sides on the ray to the right.
int WindingNumber(const GridRing& ring, int x, int y) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint& a = ring[i];
    const GridPoint& b = ring[(i + 1) % ring.size()];
    if ((a[1] <= y) == (b[1] <= y)) continue;
    const double t = (y + 0.5 - a[1]) / (b[1] - a[1]);
    if (a[0] + t * (b[0] - a[0]) > x + 0.37) winding += a[1] <= y ? 1 : -1;
  }
  return winding;
}

TEST(MergedOutline, ASharedSideIsGoneWhateverTheSenses) {
  const GridRing left = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const GridRing right = {{2, 0}, {4, 0}, {4, 2}, {2, 2}};
  const GridRing right_reversed(right.rbegin(), right.rend());
  const std::vector<GridRing> both = {
      {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {0, 2}}};
  EXPECT_EQ(Merged({left, right}), both);
  EXPECT_EQ(Merged({left, right_reversed}), both);
}

TEST(MergedOutline, WallsSeenFromAboveAreNothing) {
  EXPECT_TRUE(Merged({{{0, 0}, {5, 3}, {5, 3}, {0, 0}}}).empty());
  EXPECT_TRUE(Merged({{}, {{1, 1}}, {{1, 1}, {2, 2}}}).empty());
}

TEST(MergedOutline, WhatCoversEachOtherStaysTwice) {
  const GridRing upper = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const GridRing lower(upper.rbegin(), upper.rend());
  const std::vector<GridRing> rings = Merged({upper, lower});
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_EQ(rings[0], rings[1]);
  EXPECT_EQ(SignedArea(rings[0]), 4);
}

// Triangles with corners on few points share many sides and corners, and
// overlap.
TEST(MergedOutline, WindsAsOftenAsThePolygonsCover) {
  constexpr int kSize = 4;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, kSize);
  std::size_t fewer = 0;
  std::size_t covered_twice = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    std::vector<GridRing> triangles;
    std::size_t sides = 0;
    for (int i = 0; i < 12; ++i) {
      GridRing ring;
      for (int k = 0; k < 3; ++k)
        ring.push_back({coordinate(random), coordinate(random)});
      if (SignedArea(ring) == 0) continue;
      triangles.push_back(ring);
      sides += 3;
    }
    const std::vector<GridRing> rings = Merged(triangles);
    std::size_t left = 0;
    for (const GridRing& ring : rings) {
      left += ring.size();
      EXPECT_EQ(std::set<GridPoint>(ring.begin(), ring.end()).size(),
                ring.size());
    }
    fewer += left < sides ? 1 : 0;
    for (int x = 0; x < kSize; ++x) {
      for (int y = 0; y < kSize; ++y) {
        int covered = 0;
        for (const GridRing& triangle : triangles)
          covered += std::abs(WindingNumber(triangle, x, y));
        int winding = 0;
        for (const GridRing& ring : rings)
          winding += WindingNumber(ring, x, y);
        ASSERT_EQ(winding, covered) << repeat << ": " << x << ", " << y;
        covered_twice += covered > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(fewer, 50U);
  EXPECT_GT(covered_twice, 1000U);
}

}  // namespace
}  // namespace truelux
