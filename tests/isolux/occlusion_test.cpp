// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as hidden is hidden from everywhere: rays say so.

#include "isolux/occlusion.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

/// Whether the ray from r through x meets a triangle.
bool Meets(const Blocker& triangle, const Vec3<double>& r,
           const Vec3<double>& x) {
  // d is a sum of the ways to the corners, with shares that are positive.
  const Vec3<double> d = x - r;
  const Vec3<double> a = triangle.corners[0] - r;
  const Vec3<double> b = triangle.corners[1] - r;
  const Vec3<double> c = triangle.corners[2] - r;
  const double whole = Determinant(a, b, c);
  return Determinant(d, b, c) / whole > 0 && Determinant(a, d, c) / whole > 0 &&
         Determinant(a, b, d) / whole > 0;
}

TEST(Occlusion, WhatIsHiddenIsHiddenFromEverywhere) {
  PortableRandom random(1);
  int hidden_parts = 0;
  int clipped = 0;
  int rays = 0;
  int hidden_points = 0;
  int whole = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto place = [&] {
      return Vec3<double>{random.Uniform(-2, 2), random.Uniform(-2, 2),
                          random.Uniform(0.25, 3)};
    };
    Blocker blocker;
    blocker.corners = {place(), place(), place()};
    Vec3<double> normal = Cross(blocker.corners[1] - blocker.corners[0],
                                blocker.corners[2] - blocker.corners[0]);
    normal = (1 / std::sqrt(Dot(normal, normal))) * normal;
    blocker.plane = {normal, Dot(normal, blocker.corners[0])};
    const PlanPoint at = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
    std::array<PlanPoint, 3> corners;
    for (PlanPoint& corner : corners) {
      corner = at + PlanPoint{random.Uniform(-0.25, 0.25),
                              random.Uniform(-0.25, 0.25)};
    }
    const Occluder occluder(blocker, corners, 0x1p-40);
    if (!occluder.IsUsable()) continue;
    const Vec3<double> a = place();
    const Vec3<double> b = place();
    const auto from_inside = [&] {
      const double u = random.Unit();
      const double v = random.Unit() * (1 - u);
      const PlanPoint r = corners[0] + u * (corners[1] - corners[0]) +
                          v * (corners[2] - corners[0]);
      return Vec3<double>{r.s, r.t, 0};
    };
    if (occluder.Hides(a)) {
      ++hidden_points;
      for (int k = 0; k < 4; ++k)
        EXPECT_TRUE(Meets(blocker, from_inside(), a));
    }
    const EdgePart part = occluder.HiddenOf(a, b, {0.125, 1});
    if (part.from > part.to) continue;
    ++hidden_parts;
    EXPECT_GE(part.from, 0.125);
    EXPECT_LE(part.to, 1);
    if (part.from > 0.125 || part.to < 1) ++clipped;
    if (part.from == 0.125 && part.to == 1) ++whole;
    for (int k = 0; k < 8; ++k) {
      const double share = part.from + random.Unit() * (part.to - part.from);
      ++rays;
      EXPECT_TRUE(Meets(blocker, from_inside(), a + share * (b - a)));
    }
    // What is not hidden is seen from a corner, near the end of the part.
    if (part.to < 0.99) {
      const Vec3<double> beyond = a + (part.to + 1e-9) * (b - a);
      int meets = 0;
      for (const PlanPoint& corner : corners)
        meets += Meets(blocker, {corner.s, corner.t, 0}, beyond) ? 1 : 0;
      EXPECT_LT(meets, 3);
    }
  }
  EXPECT_GT(hidden_parts, 500);
  EXPECT_GT(clipped, 300);
  EXPECT_GT(whole, 20);
  EXPECT_GT(hidden_points, 500);
  EXPECT_GT(rays, 4000);
}

TEST(Occlusion, AFaceHidesNothingOfItsOwnOutline) {
  Blocker blocker;
  blocker.corners = {{-1, -1, 1}, {1, -1, 1}, {0, 2, 1}};
  blocker.plane = {{0, 0, 1}, 1};
  const std::array<PlanPoint, 3> corners = {{{-0.1, 0}, {0.1, 0}, {0, 0.1}}};
  const Occluder occluder(blocker, corners, 0x1p-40);
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgePart part = occluder.HiddenOf(
        blocker.corners[i], blocker.corners[(i + 1) % 3], {0, 1});
    EXPECT_GT(part.from, part.to);
  }
}

TEST(Occlusion, FromItsOwnPlaneAFaceIsNotUsed) {
  Blocker blocker;
  blocker.corners = {{1, -1, 0}, {1, 1, 0}, {1, 0, 1}};
  blocker.plane = {{1, 0, 0}, 1};
  const std::array<PlanPoint, 3> corners = {{{0, 0}, {1, 3}, {0, 1}}};
  EXPECT_FALSE(Occluder(blocker, corners, 0x1p-40).IsUsable());
}

}  // namespace
}  // namespace truelux
