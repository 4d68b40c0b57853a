// SPDX-License-Identifier: GPL-3.0-or-later
// What a search says about triangles holds at points in them; what is said
// about chords holds along them.

#include "isolux/mesh_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "isolux/contour_lines.h"
#include "isolux/level_goal.h"
#include "isolux/lit_floor.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

LitFloor FurnishedFloor() {
  std::vector<TestFace> faces = {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp},
                                 {Ceiling(1.5, 2, -2, 2, 3), kUnitLamp},
                                 {Ceiling(-2.5, -0.5, -1, 0.5, 1.5), {}}};
  AddBox(0.5, 1.75, 0.25, 1.5, 0, 1, faces);
  return {3, faces};
}

TEST(MeshSearch, RangesHoldInTriangles) {
  const LitFloor floor = FurnishedFloor();
  MeshSearch search = floor.Search();
  const std::vector<double> levels = {0.03, 0.06};
  search.Settle(LevelGoal(levels), {0.02, 0, 1000000}, 2, {});
  PortableRandom random(1);
  std::size_t bounded = 0;
  std::size_t dark = 0;
  double narrowest = HUGE_VAL;
  for (std::size_t i = 0; i < search.known().size(); ++i) {
    if (!search.known()[i].is_dark && !random.OneIn(8)) continue;
    const auto triangle = static_cast<int>(i);
    const ValueRange range = search.RangeOf(triangle);
    if (!std::isfinite(range.most)) continue;
    ++bounded;
    if (search.known()[i].is_dark) ++dark;
    narrowest = std::min(narrowest, range.most - range.least);
    const auto c = search.mesh().CornersOf(triangle);
    for (int k = 0; k < 3; ++k) {
      const double a = random.Unit();
      const double b = random.Unit() * (1 - a);
      const LightValue value =
          floor.probe().ValueAt(c[0] + a * (c[1] - c[0]) + b * (c[2] - c[0]));
      EXPECT_GE(value.value + value.bound, range.least);
      EXPECT_LE(value.value - value.bound, range.most);
    }
  }
  EXPECT_GT(bounded, 500U);
  EXPECT_GE(dark, 2U);
  EXPECT_LT(narrowest, 0.01);
}

TEST(MeshSearch, CopiesGoOnByThemselves) {
  const LitFloor floor = FurnishedFloor();
  MeshSearch search = floor.Search();
  search.RefineTo(1);
  MeshSearch copy = search;
  const std::vector<double> levels = {0.05};
  copy.Settle(LevelGoal(levels), {0.1, 0, 1000000}, 1, {});
  EXPECT_GT(copy.mesh().triangles().size(), search.mesh().triangles().size());
  EXPECT_TRUE(search.values().empty());
  EXPECT_EQ(copy.values().size(), copy.mesh().points().size());
}

TEST(MeshSearch, LimitsAreKept) {
  const LitFloor floor = FurnishedFloor();
  MeshSearch search = floor.Search();
  const std::vector<double> levels = {0.05};
  search.Settle(LevelGoal(levels), {1e-9, 0, 500}, 1, {});
  EXPECT_LT(search.mesh().triangles().size(), 600U);
  EXPECT_TRUE(std::ranges::any_of(search.known(), [](const auto& known) {
    return known.is_known && !known.is_settled;
  }));
}

TEST(ContourChords, AreAsNearAsTheySay) {
  const LitFloor floor = FurnishedFloor();
  MeshSearch search = floor.Search();
  const std::vector<double> levels = {0.03, 0.06};
  search.Settle(LevelGoal(levels), {1e-3, 0, 1000000}, 2, {});
  const double longest = 2e-4;
  const auto lines = ContourLinesOf(floor.probe(), floor.features(), search,
                                    levels, {6e-9, longest}, 2, {});
  std::size_t checked = 0;
  double closest = 0;
  for (const ContourLine& line : lines) {
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < line.widths.size(); ++i) {
      const double width = line.widths[i];
      if (!std::isfinite(width)) continue;
      EXPECT_LE(width, longest);
      const PlanPoint& a = line.points[i].at;
      const PlanPoint& b = line.points[(i + 1) % count].at;
      if (i % 4 != 0 || LengthOf(b - a) < 1e-6) continue;
      // The contour passes between both ends of a segment across the chord.
      const PlanPoint across =
          (1 / LengthOf(b - a)) * PlanPoint{-(b - a).t, (b - a).s};
      const double level = levels[line.level];
      for (const double share : {0.25, 0.5, 0.75}) {
        const PlanPoint on = a + share * (b - a);
        const double reach = 1.01 * width + 1e-8;
        const LightValue left = floor.probe().ValueAt(on + reach * across);
        const LightValue right = floor.probe().ValueAt(on - reach * across);
        EXPECT_TRUE(left.IsAbove(level) && right.IsBelow(level))
            << on.s << ", " << on.t << " width " << width;
        ++checked;
      }
      // How much of the width is needed in the middle.
      const LightSample middle = floor.probe().SampleAt(0.5 * (a + b));
      closest = std::max(closest, std::fabs(middle.light.value - level) /
                                      LengthOf(middle.gradient) / width);
    }
  }
  EXPECT_GT(checked, 300U);
  EXPECT_LE(closest, 1.01);
  EXPECT_GT(closest, 0.1);
}

}  // namespace
}  // namespace truelux
