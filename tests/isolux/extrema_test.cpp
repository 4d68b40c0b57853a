// SPDX-License-Identifier: GPL-3.0-or-later
// Maxima, minima and saddles of scenes in which they are known.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/isolux.h"

#include "isolux/light_ceiling.h"
#include "isolux/lit_floor.h"
#include "isolux/named_floor.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

std::vector<SurfaceExtremum> OfKind(const SurfaceExtrema& extrema,
                                    ExtremumKind kind) {
  std::vector<SurfaceExtremum> found;
  for (const SurfaceExtremum& point : extrema.points) {
    if (point.kind == kind) found.push_back(point);
  }
  return found;
}

double ValueAt(const Scene& scene, double x, double y) {
  return Oracle(scene).Evaluate(Receiver{{x, y, 0}, {0, 0, 1}, 1}).value[0];
}

/// E is within the bounds all over, and every extremum in its range.
void ExpectBounds(const Scene& scene, const SurfaceExtrema& extrema,
                  double half_side) {
  PortableRandom random(7);
  for (int i = 0; i < 2000; ++i) {
    const double e = ValueAt(scene, random.Uniform(-half_side, half_side),
                             random.Uniform(-half_side, half_side));
    EXPECT_GE(e, extrema.least);
    EXPECT_LE(e, extrema.most);
  }
  for (const SurfaceExtremum& point : extrema.points) {
    EXPECT_LE(point.least, point.value);
    EXPECT_GE(point.most, point.value);
    EXPECT_EQ(point.value, ValueAt(scene, point.at.x, point.at.y));
  }
}

TEST(Extrema, OneLampHasOneMaximumAndFourCorners) {
  const Scene scene = NamedFloor(4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  const SurfaceExtrema extrema = ExtremaOf(Oracle(scene), "floor", {});
  const auto maxima = OfKind(extrema, ExtremumKind::kMaximum);
  ASSERT_EQ(maxima.size(), 1U);
  EXPECT_LE(std::hypot(maxima[0].at.x, maxima[0].at.y), maxima[0].radius);
  EXPECT_LT(maxima[0].radius, 1e-3);
  EXPECT_EQ(maxima[0].on, ContourPlace::kInside);
  EXPECT_NEAR(maxima[0].value, ValueAt(scene, 0, 0), 1e-12);
  EXPECT_LT(maxima[0].most - maxima[0].least, 1e-9);
  const auto minima = OfKind(extrema, ExtremumKind::kMinimum);
  EXPECT_EQ(minima.size(), 4U);
  for (const SurfaceExtremum& point : minima) {
    EXPECT_EQ(point.on, ContourPlace::kOutline);
    EXPECT_NEAR(std::fabs(point.at.x), 4, 1e-6);
    EXPECT_NEAR(std::fabs(point.at.y), 4, 1e-6);
  }
  EXPECT_TRUE(OfKind(extrema, ExtremumKind::kSaddle).empty());
  // In the middle of each outline E along it is largest, and no extremum.
  for (const UndecidedRegion& region : extrema.undecided) {
    const Point3& p = region.triangles[0][0];
    EXPECT_NEAR(std::fmin(std::fabs(p.x), std::fabs(p.y)), 0, 1e-3);
    EXPECT_NEAR(std::fmax(std::fabs(p.x), std::fabs(p.y)), 4, 1e-3);
  }
  EXPECT_LT(extrema.undecided_area, 1e-6 * extrema.area);
  EXPECT_NEAR(extrema.most, maxima[0].value, 1e-9);
  EXPECT_NEAR(extrema.least, minima[0].value, 1e-9);
  ExpectBounds(scene, extrema, 4);
}

TEST(Extrema, TwoLampsHaveASaddleBetween) {
  const Scene scene =
      NamedFloor(4, {{Ceiling(-3, -1.5, -0.75, 0.75, 1.5), kUnitLamp},
                     {Ceiling(1.5, 3, -0.75, 0.75, 1.5), kUnitLamp}});
  const SurfaceExtrema extrema = ExtremaOf(Oracle(scene), "floor", {});
  EXPECT_EQ(OfKind(extrema, ExtremumKind::kMaximum).size(), 2U);
  const auto saddles = OfKind(extrema, ExtremumKind::kSaddle);
  ASSERT_EQ(saddles.size(), 1U);
  EXPECT_LE(std::hypot(saddles[0].at.x, saddles[0].at.y), saddles[0].radius);
  EXPECT_LT(saddles[0].radius, 1e-3);
  EXPECT_NEAR(saddles[0].value, ValueAt(scene, 0, 0), 1e-9);
  ExpectBounds(scene, extrema, 4);
}

TEST(Extrema, AMaximumMayLieOnAKink) {
  // A slit that opens to both sides of x = 0: the most light is right under
  // where both halves are seen.
  const Scene scene = NamedFloor(2, {{Ceiling(-3, 3, -3, 3, 4), kUnitLamp},
                                     {Ceiling(-3, -0.25, -3, 3, 1), {}},
                                     {Ceiling(0.25, 3, -3, 3, 1), {}}});
  const SurfaceExtrema extrema = ExtremaOf(Oracle(scene), "floor", {});
  const auto maxima = OfKind(extrema, ExtremumKind::kMaximum);
  ASSERT_EQ(maxima.size(), 1U);
  EXPECT_LE(std::hypot(maxima[0].at.x, maxima[0].at.y), maxima[0].radius);
  ExpectBounds(scene, extrema, 2);
}

TEST(Extrema, AShadowInTheMiddleIsAMinimumOrDark) {
  // A small plate: a minimum above 0 under it. A large one: darkness.
  for (const double half : {0.25, 1.5}) {
    const Scene scene =
        NamedFloor(3, {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp},
                       {Ceiling(-half, half, -half, half, 1.5), {}}});
    const SurfaceExtrema extrema = ExtremaOf(Oracle(scene), "floor", {});
    const auto minima = OfKind(extrema, ExtremumKind::kMinimum);
    const auto inside =
        std::ranges::count_if(minima, [](const SurfaceExtremum& point) {
          return std::hypot(point.at.x, point.at.y) <= point.radius;
        });
    if (ValueAt(scene, 0, 0) > 0) {
      EXPECT_EQ(inside, 1);
      EXPECT_EQ(extrema.dark_area, 0);
      EXPECT_GT(extrema.least, 0);
    } else {
      EXPECT_EQ(inside, 0);
      EXPECT_GT(extrema.dark_area, 0.5);
      EXPECT_EQ(extrema.least, 0);
    }
    ExpectBounds(scene, extrema, 3);
  }
}

TEST(LightCeiling, IsTheUnblockedLightAndABound) {
  const LitFloor floor(
      3, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp},
          {{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}}, kUnitLamp}});
  const Sight whole = WholeSight(floor.features());
  PortableRandom random(3);
  for (int i = 0; i < 200; ++i) {
    const PlanPoint p = {random.Uniform(-3, 1.75), random.Uniform(-3, 3)};
    // Neither lamp hides the other there, as seen from their fronts.
    const double light = UnblockedLight(floor.features(), whole, p);
    EXPECT_GE(light, floor.probe().ValueAt(p).value - 1e-12);
    const std::vector<PlanPoint> around = {p, p + PlanPoint{0.05, 0},
                                           p + PlanPoint{0, 0.05}};
    const double ceiling = LightCeiling(floor.features(), whole, around);
    for (const PlanPoint& q : around)
      EXPECT_GE(ceiling, UnblockedLight(floor.features(), whole, q));
    EXPECT_LT(ceiling, light + 0.5);
  }
  const LitFloor one(3, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  const Sight its = WholeSight(one.features());
  for (int i = 0; i < 100; ++i) {
    const PlanPoint p = {random.Uniform(-3, 3), random.Uniform(-3, 3)};
    EXPECT_NEAR(UnblockedLight(one.features(), its, p),
                one.probe().ValueAt(p).value, 1e-14);
  }
}

}  // namespace
}  // namespace truelux
