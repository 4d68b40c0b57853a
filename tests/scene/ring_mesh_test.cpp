// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation that decides rings of many points, against the comparison
// of all edges, on small rings that meet themselves in every way and on large
// ones.

#include "scene/ring_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/integer_ring.h"
#include "scene/polygon.h"
#include "scene/ring_spikes.h"

namespace truelux {
namespace {

using Points = std::vector<Point3>;
using Triangles = std::vector<RingTriangle>;

/// Twice the vector area of triangles of a ring.
IntegerPoint AreaOf(const IntegerRing& ring, const Triangles& triangles) {
  IntegerPoint sum{0, 0, 0};
  for (const RingTriangle& t : triangles) {
    const IntegerPoint& a = ring.At(static_cast<std::size_t>(t[0]));
    const IntegerPoint& b = ring.At(static_cast<std::size_t>(t[1]));
    const IntegerPoint& c = ring.At(static_cast<std::size_t>(t[2]));
    // No minus between sums: operator+ is not there.
    sum = sum - Cross(c - a, b - a);
  }
  return sum;
}

TEST(RingMesh, AgreesWithTheComparisonOfAllEdges) {
  std::mt19937_64 random(41);
  std::map<std::string, int> seen;
  const auto same = [](const IntegerPoint& a, const IntegerPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  const RoundUpward rounding;
  for (int i = 0; i < 40000; ++i) {
    IntegerRing ring = RandomIntegerRing(random, 4 + random() % 7,
                                         random() % 2 == 0 ? 3 : 4, true);
    RemoveSpikes(ring.points, same);
    if (ring.size() < 4) continue;
    const Points points = ring.Points();
    ProjectedRing projected;
    if (projected.Project(points) != RingShape::kPlanar) continue;
    Triangles triangles;
    const RingInside inside = MeshInside(projected, triangles);
    ASSERT_EQ(inside, FindInside(projected)) << i;
    const bool is_simple = !FindContact(projected);
    ++seen[(is_simple ? "simple " : "meets itself ") +
           std::to_string(static_cast<int>(inside))];
    if (inside != RingInside::kOnce) {
      ASSERT_TRUE(triangles.empty());
      continue;
    }
    const IntegerPoint area = AreaOf(ring, triangles);
    ASSERT_TRUE(same(area, ring.Normal())) << i;
    for (const RingTriangle& t : triangles)
      ASSERT_EQ(projected.Orientation(t[0], t[1], t[2]), Sign::kPositive);
  }
  for (const char* kind : {"simple 1", "meets itself 1", "meets itself 2"})
    EXPECT_GT(seen[kind], 20) << kind;
}

/// The ring in a plane that is not level, so that nothing is rounded.
Points Tilted(const std::vector<std::array<double, 2>>& flat) {
  Points points;
  for (const auto& [x, y] : flat)
    points.push_back({x, y, 2 * x - y});
  return points;
}

/// A comb with teeth of width 1 and gaps of width 1.
Points Comb(int teeth) {
  std::vector<std::array<double, 2>> flat;
  for (int i = 0; i < teeth; ++i) {
    const double x = 2.0 * i;
    flat.insert(flat.end(), {{x, 1}, {x, 9}, {x + 1, 9}, {x + 1, 1}});
  }
  flat.insert(flat.end(), {{2.0 * teeth, 1}, {2.0 * teeth, 0}, {0, 0}});
  return Tilted(flat);
}

/// Twice the area of triangles, seen from above.
double FlatArea(const Points& points, std::span<const RingTriangle> triangles) {
  double sum = 0;
  for (const RingTriangle& t : triangles) {
    const Point3& a = points[static_cast<std::size_t>(t[0])];
    const Point3& b = points[static_cast<std::size_t>(t[1])];
    const Point3& c = points[static_cast<std::size_t>(t[2])];
    sum += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return sum;
}

TEST(RingMesh, ACombOfAHundredThousandPoints) {
  const int teeth = 25000;
  Points comb = Comb(teeth);
  PolygonReader reader;
  for (const bool reversed : {false, true}) {
    ASSERT_EQ(reader.Read(comb), PolygonKind::kPlanar);
    EXPECT_EQ(std::fabs(FlatArea(comb, reader.triangles())),
              2 * (2.0 * teeth + 8.0 * teeth));
    if (!reversed) std::ranges::reverse(comb);
  }
}

TEST(RingMesh, AConvexRingOfManyPoints) {
  // Points of a parabola are convex, whole and as near as they like.
  std::vector<std::array<double, 2>> flat;
  const int n = 40000;
  for (int i = -n; i <= n; ++i) {
    const double x = i;
    flat.push_back({x, x * x});
  }
  const Points points = Tilted(flat);
  PolygonReader reader;
  ASSERT_EQ(reader.Read(points), PolygonKind::kPlanar);
  EXPECT_EQ(reader.triangles().size(), points.size() - 2);
}

TEST(RingMesh, ALargeRingThatIsNotPlanarIsRefused) {
  Points comb = Comb(2501);
  comb.back().z += 1;
  PolygonReader reader;
  EXPECT_EQ(reader.Read(comb), PolygonKind::kTooLarge);
  comb.erase(comb.begin(), comb.begin() + 4);
  ASSERT_EQ(comb.size(), 10003U);
  comb.erase(comb.begin(), comb.begin() + 3);
  EXPECT_EQ(reader.Read(comb), PolygonKind::kNotPlanar);
}

}  // namespace
}  // namespace truelux
