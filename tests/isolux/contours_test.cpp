// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of scenes whose answers are known.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/isolux.h"
#include "truelux/stop.h"

#include "isolux/lit_floor.h"
#include "isolux/named_floor.h"
#include "support/random_scene.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// Every vertex is certified, and its transversal says so when asked again.
void ExpectCertified(const Scene& scene, const Isolux& isolux, double width) {
  const Oracle oracle(scene);
  std::size_t count = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    EXPECT_EQ(contour.widths.size() + (contour.is_closed ? 0 : 1),
              contour.vertices.size());
    for (const IsoluxVertex& v : contour.vertices) {
      ++count;
      EXPECT_TRUE(v.is_certified);
      EXPECT_LE(v.half_width, width);
      EXPECT_NEAR(std::hypot(v.across.x, v.across.y, v.across.z), 1, 1e-12);
      const auto value = [&](double way) {
        return oracle
            .Evaluate(
                Receiver{{v.at.x + way * v.across.x, v.at.y + way * v.across.y,
                          v.at.z + way * v.across.z},
                         {0, 0, 1},
                         1})
            .value[0];
      };
      EXPECT_LT(value(-1.001 * v.half_width), contour.level);
      EXPECT_GT(value(1.001 * v.half_width), contour.level);
    }
  }
  EXPECT_GT(count, 20U);
}

TEST(Contours, OfASquareLampAreClosedAndSymmetric) {
  const Scene scene = NamedFloor(4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  IsoluxOptions options;
  options.levels = {0.125, 0.1875, 0.22};
  const Isolux isolux = FloorIsolux(scene, options);
  EXPECT_TRUE(isolux.open.empty());
  EXPECT_EQ(isolux.open_area, 0);
  EXPECT_EQ(isolux.dark_area, 0);
  EXPECT_NEAR(isolux.area, 64, 1e-6);
  ASSERT_EQ(isolux.contours.size(), 3U);
  ExpectCertified(scene, isolux, 1e-9 * isolux.size);
  const Oracle oracle(scene);
  for (std::size_t k = 0; k < 3; ++k) {
    const IsoluxContour& contour = isolux.contours[k];
    EXPECT_EQ(contour.level, options.levels[k]);
    EXPECT_TRUE(contour.is_closed);
    double area = 0;
    for (const auto& [a, b] : ChordsOf(contour, FlatXY))
      area += Turn({0, 0}, a, b) / 2;
    // What is larger, the inside, is on the left.
    EXPECT_GT(area, 0);
    // A mirrored transversal brackets the contour, too.
    for (const IsoluxVertex& v : contour.vertices) {
      for (const double end : {-1.0, 1.0}) {
        const double x = v.at.x + end * v.half_width * v.across.x;
        const double y = v.at.y + end * v.half_width * v.across.y;
        for (const Point3& p :
             {Point3{-x, y, 0}, Point3{x, -y, 0}, Point3{y, x, 0}}) {
          const double value =
              oracle.Evaluate(Receiver{p, {0, 0, 1}, 1}).value[0];
          EXPECT_GT(end * (value - contour.level), 0);
        }
      }
    }
  }
}

TEST(Contours, OfADiscAreCircles) {
  constexpr int kSides = 128;
  constexpr double kRadius = 1;
  constexpr double kHeight = 2;
  Ring ring;
  for (int i = 0; i < kSides; ++i) {
    const double turn = -2 * std::numbers::pi * i / kSides;
    ring.push_back(
        {kRadius * std::cos(turn), kRadius * std::sin(turn), kHeight});
  }
  const Scene scene = NamedFloor(3, {{ring, kUnitLamp}});
  IsoluxOptions options;
  options.levels = {0.0625, 0.1875};
  const Isolux isolux = FloorIsolux(scene, options);
  EXPECT_TRUE(isolux.open.empty());
  ASSERT_EQ(isolux.contours.size(), 2U);
  for (const IsoluxContour& contour : isolux.contours) {
    // Lambert's disc: E = M/2 (1 - (x2 + h2 - a2) / sqrt((x2 + h2 + a2)^2
    // - 4 a2 x2)) at a distance x from its axis.
    const auto disc = [](double x) {
      const double sum = x * x + kHeight * kHeight;
      const double wide = sum + kRadius * kRadius;
      return 0.5 *
             (1 - (sum - kRadius * kRadius) /
                      std::sqrt(wide * wide - 4 * kRadius * kRadius * x * x));
    };
    double low = 0;
    double high = 10;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (disc(middle) > contour.level ? low : high) = middle;
    }
    // The polygon has a little less area than the disc, and so many sides that
    // its contours are rounder than anything that double tells.
    const double first =
        std::hypot(contour.vertices[0].at.x, contour.vertices[0].at.y);
    EXPECT_NEAR(first, low, 2e-3);
    for (const IsoluxVertex& v : contour.vertices)
      EXPECT_NEAR(std::hypot(v.at.x, v.at.y), first, 1e-9 * isolux.size);
  }
}

TEST(Contours, OfATriangleAreWhereItsFormulaSays) {
  const Ring ring = {{-1, -0.5, 1.5}, {0.25, 1, 2.5}, {1.25, -0.75, 2}};
  const Scene scene = NamedFloor(3, {{ring, kUnitLamp}});
  // Lambert's formula in long double, 1e-18 of its terms.
  const auto formula = [&ring](long double x, long double y) {
    long double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = ring[i];
      const Point3& q = ring[(i + 1) % 3];
      const long double ax = p.x - x;
      const long double ay = p.y - y;
      const long double bx = q.x - x;
      const long double by = q.y - y;
      const long double cx = ay * q.z - p.z * by;
      const long double cy = p.z * bx - ax * q.z;
      const long double cz = ax * by - ay * bx;
      const long double sine = std::sqrt(cx * cx + cy * cy + cz * cz);
      const long double cosine =
          ax * bx + ay * by + static_cast<long double>(p.z) * q.z;
      sum += std::atan2(sine, cosine) * cz / sine;
    }
    return std::fabs(sum) / (2 * std::numbers::pi_v<long double>);
  };
  IsoluxOptions options;
  options.levels = {0.03, 0.0625};
  const Isolux isolux = FloorIsolux(scene, options);
  ASSERT_GE(isolux.contours.size(), 2U);
  ExpectCertified(scene, isolux, 1e-9 * isolux.size);
  std::size_t checked = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    for (const IsoluxVertex& v : contour.vertices) {
      long double low = -1e-6L;
      long double high = 1e-6L;
      for (int i = 0; i < 60; ++i) {
        const long double middle = (low + high) / 2;
        const long double value =
            formula(v.at.x + middle * v.across.x, v.at.y + middle * v.across.y);
        (value < contour.level ? low : high) = middle;
      }
      EXPECT_LE(std::fabs(low), v.half_width);
      ++checked;
    }
  }
  EXPECT_GT(checked, 50U);
}

TEST(Contours, GoOnAcrossKinks) {
  // Two edges in the plane x = 0 before the lamp.
  const Scene scene = NamedFloor(2, {{Ceiling(-3, 3, -1, 1, 4), kUnitLamp},
                                     {Ceiling(-3, 0, -3, 3, 1), {}},
                                     {Ceiling(0, 3, -0.5, 3, 2), {}}});
  IsoluxOptions options;
  options.count = 6;
  const Isolux isolux = FloorIsolux(scene, options);
  const auto at_x0 = [](const SurfaceLine& line) {
    return line.ends[0].x == 0 && line.ends[1].x == 0;
  };
  EXPECT_GT(std::ranges::count_if(isolux.lines.lines, at_x0), 0);
  std::size_t on_kink = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
      const IsoluxVertex& v = contour.vertices[i];
      if (v.on != ContourPlace::kKink) continue;
      EXPECT_TRUE(v.is_certified);
      // A kink ends no contour.
      EXPECT_TRUE(contour.is_closed ||
                  (i > 0 && i + 1 < contour.vertices.size()));
      if (std::fabs(v.at.x) < 1e-12) ++on_kink;
    }
  }
  EXPECT_GT(on_kink, 2U);
}

TEST(Contours, EndAtWalls) {
  std::vector<TestFace> faces = {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp}};
  AddBox(0.5, 1.75, 0.25, 1.5, 0, 1.5, faces);
  const Scene scene = NamedFloor(3, faces);
  IsoluxOptions options;
  options.count = 5;
  const Isolux isolux = FloorIsolux(scene, options);
  ExpectCertified(scene, isolux, 1e-9 * isolux.size);
  std::size_t ends_at_walls = 0;
  std::size_t checked = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    if (!contour.is_closed) {
      for (const IsoluxVertex* v :
           {&contour.vertices.front(), &contour.vertices.back()}) {
        EXPECT_TRUE(v->on == ContourPlace::kJump ||
                    v->on == ContourPlace::kOutline);
        ends_at_walls += v->on == ContourPlace::kJump ? 1 : 0;
      }
    }
    for (const auto& chord : ChordsOf(contour, FlatXY)) {
      for (const SurfaceLine& line : isolux.lines.lines) {
        if (line.kind != SurfaceLineKind::kJump) continue;
        ++checked;
        EXPECT_FALSE(
            Cross(chord, {FlatXY(line.ends[0]), FlatXY(line.ends[1])}));
      }
    }
  }
  EXPECT_GT(ends_at_walls, 2U);
  EXPECT_GT(checked, 1000U);
  // Under the box it is dark, and behind it.
  EXPECT_GT(isolux.dark_area, 1.25 * 1.25);
  EXPECT_LT(isolux.dark_area, 3);
}

TEST(Contours, OfAnExactValuePassThere) {
  const Scene scene = NamedFloor(4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  const double level =
      Oracle(scene).Evaluate(Receiver{{2, 0, 0}, {0, 0, 1}, 1}).value[0];
  IsoluxOptions options;
  options.levels = {level};
  const Isolux isolux = FloorIsolux(scene, options);
  ASSERT_EQ(isolux.contours.size(), 1U);
  EXPECT_TRUE(isolux.contours[0].is_closed);
  // Sides of triangles touch the contour there, so that some are not settled.
  EXPECT_LT(isolux.open_area, 1e-7 * isolux.area);
  for (const OpenTriangle& open : isolux.open)
    EXPECT_NEAR(std::hypot(open.corners[0].x, open.corners[0].y), 2, 1e-3);
  double nearest = HUGE_VAL;
  for (const auto& chord : ChordsOf(isolux.contours[0], FlatXY))
    nearest = std::min(nearest, DistanceTo({2, 0}, chord));
  EXPECT_LT(nearest, 1e-3 * isolux.size);
  ExpectCertified(scene, isolux, 1e-9 * isolux.size);
}

TEST(Contours, WhatCannotBeAskedForIsRefused) {
  const Scene scene = NamedFloor(4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  const Oracle oracle(scene);
  IsoluxOptions options;
  EXPECT_THROW((void)IsoluxOf(oracle, "wall", options), std::invalid_argument);
  options.levels = {0};
  EXPECT_THROW((void)IsoluxOf(oracle, "floor", options), std::invalid_argument);
  options.levels = {0.5, 0.25};
  EXPECT_THROW((void)IsoluxOf(oracle, "floor", options), std::invalid_argument);
  options.levels = {std::nan("")};
  EXPECT_THROW((void)IsoluxOf(oracle, "floor", options), std::invalid_argument);
  options.levels = {};
  options.count = 0;
  EXPECT_THROW((void)IsoluxOf(oracle, "floor", options), std::invalid_argument);
  options.count = 1;
  options.chord = -1;
  EXPECT_THROW((void)IsoluxOf(oracle, "floor", options), std::invalid_argument);
}

TEST(Contours, CanBeStopped) {
  const Scene scene = NamedFloor(4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}});
  const StopFlag stop = true;
  OracleOptions options;
  options.stop = &stop;
  EXPECT_THROW((void)IsoluxOf(Oracle(scene, options), "floor", {}), Stopped);
}

TEST(Contours, ADarkFloorHasNone) {
  const Scene scene = NamedFloor(4, {{Floor(-1, 1, -1, 1, 2), kUnitLamp}});
  const Isolux isolux = FloorIsolux(scene, {});
  EXPECT_TRUE(isolux.levels.empty());
  EXPECT_TRUE(isolux.contours.empty());
  EXPECT_TRUE(isolux.open.empty());
  EXPECT_EQ(isolux.most, 0);
  ASSERT_EQ(isolux.lines.notes.size(), 1U);
}

TEST(Contours, APlateauIsOpenAndNotTraced) {
  // Inside a box whose walls and ceiling all emit the same, E = M.
  std::vector<TestFace> faces;
  for (const Ring& ring : BoxAround(2)) {
    Ring raised = ring;
    for (Point3& p : raised)
      p.z += 2;
    faces.push_back({raised, kUnitLamp});
  }
  const Scene scene = NamedFloor(2, faces);
  IsoluxOptions options;
  options.levels = {1};
  const Isolux isolux = FloorIsolux(scene, options);
  EXPECT_EQ(isolux.least, 1);
  EXPECT_EQ(isolux.most, 1);
  EXPECT_TRUE(isolux.contours.empty());
  EXPECT_GT(isolux.open_area, 0.9 * isolux.area);
  EXPECT_LT(isolux.triangles, 100000U);
}

TEST(Contours, DoNotDependOnThreads) {
  std::vector<TestFace> faces = {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp}};
  AddBox(0.5, 1.75, 0.25, 1.5, 0, 1.5, faces);
  const Scene scene = NamedFloor(3, faces);
  IsoluxOptions options;
  options.count = 4;
  options.smallest = 1e-3;
  const Isolux one = FloorIsolux(scene, options);
  options.threads = 3;
  const Isolux three = FloorIsolux(scene, options);
  ASSERT_EQ(one.contours.size(), three.contours.size());
  EXPECT_EQ(one.open.size(), three.open.size());
  for (std::size_t i = 0; i < one.contours.size(); ++i) {
    EXPECT_EQ(one.contours[i].widths, three.contours[i].widths);
    ASSERT_EQ(one.contours[i].vertices.size(),
              three.contours[i].vertices.size());
    for (std::size_t k = 0; k < one.contours[i].vertices.size(); ++k) {
      EXPECT_EQ(one.contours[i].vertices[k].at,
                three.contours[i].vertices[k].at);
    }
  }
}

}  // namespace
}  // namespace truelux
