// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of numbers stay in their boxes, and no two characters look alike.

#include "draw/stroke_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

constexpr std::string_view kCharacters = "0123456789.-+e";

/// How far a point is from the strokes.
double DistanceTo(const std::vector<PaperPath>& strokes, const PaperPoint& p) {
  double least = HUGE_VAL;
  for (const PaperPath& path : strokes) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const PaperPoint way = {path[i].x - path[i - 1].x,
                              path[i].y - path[i - 1].y};
      const PaperPoint to = {p.x - path[i - 1].x, p.y - path[i - 1].y};
      const double square = way.x * way.x + way.y * way.y;
      const double share =
          square > 0
              ? std::clamp((to.x * way.x + to.y * way.y) / square, 0.0, 1.0)
              : 0;
      least = std::min(least,
                       std::hypot(to.x - share * way.x, to.y - share * way.y));
    }
  }
  return least;
}

TEST(StrokeText, StaysInItsBox) {
  for (const char c : kCharacters) {
    const std::string text(1, c);
    const auto strokes = TextStrokes(text);
    ASSERT_FALSE(strokes.empty()) << c;
    for (const PaperPath& path : strokes) {
      EXPECT_GE(path.size(), 2U) << c;
      for (const PaperPoint& p : path) {
        EXPECT_GE(p.x, -0.001) << c;
        EXPECT_LE(p.x, StrokeTextWidth(text) + 0.001) << c;
        EXPECT_GE(p.y, -1.001) << c;
        EXPECT_LE(p.y, 0.001) << c;
      }
    }
  }
  EXPECT_TRUE(TextStrokes("").empty());
  EXPECT_EQ(StrokeTextWidth(""), 0);
  EXPECT_TRUE(TextStrokes("x").empty());
}

TEST(StrokeText, NoTwoCharactersLookAlike) {
  for (const char a : kCharacters) {
    for (const char b : kCharacters) {
      if (a == b) continue;
      const auto one = TextStrokes(std::string(1, a));
      const auto other = TextStrokes(std::string(1, b));
      double farthest = 0;
      for (const auto& [from, to] : {std::pair{&one, &other}, {&other, &one}}) {
        for (const PaperPath& path : *from) {
          for (const PaperPoint& p : path)
            farthest = std::max(farthest, DistanceTo(*to, p));
        }
      }
      EXPECT_GT(farthest, 0.15) << a << ' ' << b;
    }
  }
}

TEST(StrokeText, CharactersFollowEachOther) {
  const auto pair = TextStrokes("1.");
  const auto one = TextStrokes("1");
  ASSERT_EQ(pair.size(), one.size() + 1);
  EXPECT_GT(pair.back()[0].x, StrokeTextWidth("1"));
  EXPECT_GT(StrokeTextWidth("0.25"), StrokeTextWidth("0.2"));
}

}  // namespace
}  // namespace truelux
