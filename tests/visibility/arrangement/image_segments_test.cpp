// SPDX-License-Identifier: GPL-3.0-or-later
// Segments without overlaps against a plain count, on few lines of a lattice,
// where most segments overlap others.

#include "visibility/arrangement/image_segments.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

using Point = Kernel::Point_2;

/// Directions of lines: level, vertical, rising and falling.
constexpr int kSteps[4][2] = {{1, 0}, {0, 1}, {2, 1}, {1, -3}};

Point At(int line, int shift, int place) {
  const auto& step = kSteps[line];
  // Lines of one direction differ by the shift, which no step can make up.
  return {place * step[0] - shift * step[1], place * step[1] + shift * step[0]};
}

/// Whether a segment covers what is between neighbouring places of its line.
bool Covers(const ImageSegment& s, const Point& p, const Point& q) {
  // Where no other line of the lattice crosses.
  const Point between = p + (q - p) / Kernel::FT(97);
  return s.line.has_on(between) && s.begin < between && between < s.end;
}

/// The triangles of all segments that cover what is between p and q.
TriangleIds CoverOf(const std::vector<ImageSegment>& segments, const Point& p,
                    const Point& q) {
  TriangleIds cover;
  for (const ImageSegment& s : segments) {
    if (!Covers(s, p, q)) continue;
    cover.insert(cover.end(), s.triangles.begin(), s.triangles.end());
  }
  std::sort(cover.begin(), cover.end());
  return cover;
}

int CountCovering(const std::vector<ImageSegment>& segments, const Point& p,
                  const Point& q) {
  return static_cast<int>(
      std::count_if(segments.begin(), segments.end(),
                    [&](const auto& s) { return Covers(s, p, q); }));
}

TEST(ImageSegments, PartsCoverWhatTheSegmentsCoverOnce) {
  constexpr int kPlaces = 6;
  std::mt19937 random(3);
  const auto below = [&random](int n) {
    return static_cast<int>(random() % static_cast<unsigned>(n));
  };
  int shared = 0;
  int bare = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<ImageSegment> segments;
    for (int i = 0; i < 14; ++i) {
      const int line = below(4);
      const int shift = below(2);
      const int from = below(kPlaces);
      const int to = (from + 1 + below(kPlaces - 1)) % kPlaces;
      // None for a line where two triangles meet.
      TriangleIds ids;
      if (below(5) != 0) ids.emplace_back(i);
      segments.emplace_back(At(line, shift, from), At(line, shift, to), ids);
    }
    const std::vector<ImageSegment> parts = WithoutOverlaps(segments);
    for (int line = 0; line < 4; ++line) {
      for (int shift = 0; shift < 2; ++shift) {
        for (int k = 0; k + 1 < kPlaces; ++k) {
          const Point p = At(line, shift, k);
          const Point q = At(line, shift, k + 1);
          const int before = CountCovering(segments, p, q);
          EXPECT_EQ(CountCovering(parts, p, q), std::min(before, 1));
          EXPECT_EQ(CoverOf(parts, p, q), CoverOf(segments, p, q));
          if (before > 1) ++shared;
          if (before == 0) ++bare;
        }
      }
    }
  }
  EXPECT_GT(shared, 300);
  EXPECT_GT(bare, 300);
}

TEST(ImageSegments, ASegmentGoesFromItsFirstPointByX) {
  const ImageSegment s(Point(2, 0), Point(1, 5), {});
  EXPECT_EQ(s.begin, Point(1, 5));
  const ImageSegment vertical(Point(1, 5), Point(1, 2), {});
  EXPECT_EQ(vertical.begin, Point(1, 2));
  EXPECT_EQ(CompareLines(vertical, s), CGAL::SMALLER);
  EXPECT_EQ(CompareLines(s, vertical), CGAL::LARGER);
}

}  // namespace
}  // namespace truelux
