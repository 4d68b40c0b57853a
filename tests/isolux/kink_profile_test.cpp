// SPDX-License-Identifier: GPL-3.0-or-later
// Two blockers whose parallel edges cover each other (Arvo 1994, Figure 2): on
// one side of the line only one of them counts, on the other side only the
// other one, and contours bend there.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "isolux/lit_floor.h"
#include "isolux/named_floor.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

const TestFace kLampAbove = {Ceiling(-3, 3, -2, 2, 4), kUnitLamp};
const TestFace kNear = {Ceiling(-20, 0, -20, 20, 1), {}};
const TestFace kFar = {Ceiling(-20, 0, -20, 20, 2), {}};

Receiver At(double x, double y) {
  return {{x, y, 0}, {0, 0, 1}, 1};
}

Vector3 SlopeAt(const Oracle& oracle, double x, double y) {
  return oracle.Derivatives(At(x, y)).channels[0].tangential;
}

TEST(KinkProfile, IsThatOfOneBlockerOnEachSide) {
  const Oracle both(NamedFloor(2, {kLampAbove, kNear, kFar}));
  const Oracle near(NamedFloor(2, {kLampAbove, kNear}));
  const Oracle far(NamedFloor(2, {kLampAbove, kFar}));
  int different = 0;
  for (int i = -16; i <= 16; ++i) {
    const double x = i / 16.0;
    const double e = both.Evaluate(At(x, 0.25)).value[0];
    const double with_near = near.Evaluate(At(x, 0.25)).value[0];
    const double with_far = far.Evaluate(At(x, 0.25)).value[0];
    EXPECT_EQ(e, x < 0 ? with_near : with_far) << x;
    different += with_near == with_far ? 0 : 1;
  }
  EXPECT_GT(different, 20);
}

TEST(KinkProfile, BendsByTwiceTheSizeOfTheLine) {
  const Oracle oracle(NamedFloor(2, {kLampAbove, kNear, kFar}));
  const SurfaceLines lines = SurfaceLinesOf(oracle, "floor");
  EXPECT_TRUE(lines.is_complete);
  std::size_t compared = 0;
  for (const SurfaceLine& line : lines.lines) {
    if (line.kind != SurfaceLineKind::kKink || line.ends[0].x != 0 ||
        line.ends[1].x != 0) {
      continue;
    }
    const double y = (line.ends[0].y + line.ends[1].y) / 2;
    const double aside = 0x1p-30;
    const double jump =
        SlopeAt(oracle, aside, y).x - SlopeAt(oracle, -aside, y).x;
    EXPECT_NEAR(jump, 2 * line.size[0], 1e-7);
    EXPECT_GT(std::fabs(line.size[0]), 0.01);
    EXPECT_EQ(line.edges.size(), 2U);
    ++compared;
  }
  EXPECT_GE(compared, 1U);
}

TEST(KinkProfile, ContoursBendAsTheGradientsSay) {
  const Oracle oracle(NamedFloor(2, {kLampAbove, kNear, kFar}));
  IsoluxOptions options;
  // Contours that cross x = 0: irradiance falls along it, away from y = 0.
  options.levels = {oracle.Evaluate(At(0, 1)).value[0] * 0.999,
                    oracle.Evaluate(At(0, 0.5)).value[0] * 1.001};
  options.chord = 1e-7;
  options.smallest = 1e-4;
  const Isolux isolux = IsoluxOf(oracle, "floor", options);
  std::size_t bends = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    const std::size_t count = contour.vertices.size();
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const IsoluxVertex& v = contour.vertices[i];
      if (v.on != ContourPlace::kKink || std::fabs(v.at.x) > 1e-12) continue;
      EXPECT_TRUE(v.is_certified);
      std::array<double, 2> turns{};
      for (const std::size_t side : {i - 1, i + 1}) {
        const Point3& other = contour.vertices[side].at;
        const double sense = other.x > 0 ? 1 : -1;
        const Vector3 g = SlopeAt(oracle, sense * 0x1p-30, v.at.y);
        const double dx = other.x - v.at.x;
        const double dy = other.y - v.at.y;
        // The chord is across the gradient of its own side, and not across that
        // of the other one.
        const double length = std::hypot(dx, dy);
        const double slope = std::hypot(g.x, g.y);
        EXPECT_NEAR((dx * g.x + dy * g.y) / (length * slope), 0, 2e-3);
        turns[side == i + 1 ? 1 : 0] = std::atan2(g.y, g.x);
      }
      EXPECT_GT(std::fabs(turns[1] - turns[0]), 0.02);
      ++bends;
    }
  }
  EXPECT_GE(bends, 2U);
}

}  // namespace
}  // namespace truelux
