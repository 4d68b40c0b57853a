// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/triangulation.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/integer_ring.h"
#include "scene/polygon.h"

namespace truelux {
namespace {

using Ring = std::vector<Point3>;
using Triangles = std::vector<RingTriangle>;

Triangles TrianglesOf(const Ring& ring) {
  PolygonReader reader;
  reader.Read(ring);
  return {reader.triangles().begin(), reader.triangles().end()};
}

TEST(Triangulation, AConvexRingIsAFan) {
  EXPECT_EQ(TrianglesOf({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {0, 1, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulation, ARingThatBendsAtItsFirstVertexLosesEarsInOrder) {
  // Vertex 0 is reflex in a dart: the fan from it would still do, but the fan
  // from vertex 1 of the same ring would not.
  EXPECT_EQ(TrianglesOf({{1, 1, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(TrianglesOf({{4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}}),
            (Triangles{{3, 0, 1}, {3, 1, 2}}));
}

TEST(Triangulation, StraightVerticesMakeNoTriangleWithoutArea) {
  EXPECT_EQ(TrianglesOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}),
            (Triangles{{3, 0, 1}, {3, 1, 2}}));
}

TEST(Triangulation, AgreesWithTheRuleWordForWordOnRandomRings) {
  std::mt19937_64 random(13);
  int fans = 0;
  int clipped = 0;
  while (fans + clipped < 4000) {
    const IntegerRing ring = RandomIntegerRing(
        random, 4 + random() % 7, random() % 2 == 0 ? 4 : 9, random() % 2 == 0);
    if (ring.OnOneLine() || !ring.IsSimple()) continue;
    const Triangles expected = ring.Triangles();
    ASSERT_EQ(expected.size(), ring.size() - 2);
    ASSERT_EQ(TrianglesOf(ring.Points()), expected);
    const bool is_fan = expected[0][0] == 0 && expected[0][1] == 1;
    ++(is_fan ? fans : clipped);
  }
  EXPECT_GT(fans, 1000);
  EXPECT_GT(clipped, 1000);
}

/// A star-shaped ring around the origin with corners on a fine grid.
Ring Star(std::mt19937_64& random, int n, double height) {
  constexpr double kPi = 3.141592653589793;
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double radius = 1 + static_cast<double>(random() % 1000) / 200;
    const double angle = 2 * kPi * i / n;
    const double z = height * static_cast<double>(random() % 1000);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return ring;
}

/// Twice the area of a triangle in the plane z = 0, exactly.
Exact Turn(const Point3& a, const Point3& b, const Point3& c) {
  return (Exact(b.x) - Exact(a.x)) * (Exact(c.y) - Exact(a.y)) -
         (Exact(b.y) - Exact(a.y)) * (Exact(c.x) - Exact(a.x));
}

TEST(Triangulation, EveryPointOfALargePolygonIsInOneTriangle) {
  std::mt19937_64 random(17);
  const Ring ring = Star(random, 300, 0);
  const Triangles triangles = TrianglesOf(ring);
  ASSERT_EQ(triangles.size(), ring.size() - 2);
  const auto corner = [&](int i) { return ring[static_cast<std::size_t>(i)]; };
  const Point3 centre{0, 0, 0};
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const Point3 p{static_cast<double>(random() % 2001) / 200 - 5,
                   static_cast<double>(random() % 2001) / 200 - 5, 0};
    const auto contains = [&](const Point3& a, const Point3& b,
                              const Point3& c) {
      return Turn(a, b, p) > 0 && Turn(b, c, p) > 0 && Turn(c, a, p) > 0;
    };
    int in_fan = 0;  // around the centre, from which all of the star is seen
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (contains(centre, ring[k], ring[(k + 1) % ring.size()])) ++in_fan;
    }
    int in_triangles = 0;
    for (const RingTriangle& t : triangles) {
      if (contains(corner(t[0]), corner(t[1]), corner(t[2]))) ++in_triangles;
    }
    EXPECT_EQ(in_triangles, in_fan);
    inside += in_fan;
  }
  EXPECT_GT(inside, 100);
}

TEST(Triangulation, AThousandVerticesAreNoBurden) {
  std::mt19937_64 random(19);
  EXPECT_EQ(TrianglesOf(Star(random, 1000, 0)).size(), 998U);
  EXPECT_EQ(TrianglesOf(Star(random, 1000, 1e-6)).size(), 998U);
}

}  // namespace
}  // namespace truelux
