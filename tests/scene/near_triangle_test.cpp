// SPDX-License-Identifier: GPL-3.0-or-later
// The answers about a triangle near a receiver against quotients of whole
// numbers, on grids so coarse that ties of all kinds are frequent.

#include "scene/near_triangle.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/near_twin.h"
#include "support/portable_random.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using testing::NearTwin;
using testing::NearTwinOf;
using testing::PortableRandom;

using Corners = std::array<Point3, 3>;

Point3 PointOnGrid(PortableRandom& random, int size) {
  const auto next = [&] {
    return static_cast<double>(random.Integer(-size, size));
  };
  const double x = next();
  const double y = next();
  return {x, y, next()};
}

bool HasArea(const Corners& c) {
  const RationalVector a = RationalOf(c[0]);
  const RationalVector m = Cross(RationalOf(c[1]) - a, RationalOf(c[2]) - a);
  return Dot(m, m) != 0;
}

Corners TriangleOnGrid(PortableRandom& random) {
  for (;;) {
    Corners corners;
    for (Point3& p : corners)
      p = PointOnGrid(random, 4);
    if (HasArea(corners)) return corners;
  }
}

Receiver ReceiverOnGrid(PortableRandom& random) {
  Receiver receiver;
  receiver.position = PointOnGrid(random, 4);
  do {
    const Point3 n = PointOnGrid(random, 1);
    receiver.normal = {n.x, n.y, n.z};
  } while (receiver.normal == Vector3{0, 0, 0});
  return receiver;
}

int SignOfDifference(const mpq_class& a, const mpq_class& b) {
  return a < b ? -1 : a > b ? 1 : 0;
}

TEST(NearTriangle, AgreesWithQuotients) {
  PortableRandom random(20261128);
  const RoundUpward rounding;
  std::array<int, 4> turns{};
  std::array<int, 2> plane_ties{};
  int foot_ties = 0;
  int distance_ties = 0;
  int behind = 0;
  const int count = testing::SweepSize(3000, 30000);
  for (int i = 0; i < count; ++i) {
    const Receiver receiver = ReceiverOnGrid(random);
    const Corners a = TriangleOnGrid(random);
    // Every fifth has the same corners, from another one on.
    const Corners b =
        i % 5 == 0 ? Corners{a[1], a[2], a[0]} : TriangleOnGrid(random);
    const NearTriangle near(a, receiver);
    const NearTriangle other(b, receiver);
    const NearTwin twin = NearTwinOf(a, receiver);
    const NearTwin other_twin = NearTwinOf(b, receiver);
    ASSERT_EQ(static_cast<int>(near.TurnOf()), twin.turn) << i;
    ++turns[static_cast<std::size_t>(twin.turn)];
    ASSERT_EQ(near.HasReceiverBehind(), twin.is_behind) << i;
    behind += twin.is_behind ? 1 : 0;
    for (int t = 0; t <= 5; ++t) {
      const NearLimit limit{static_cast<double>(t), 0, 0, 0};
      ASSERT_EQ(near.IsPlaneWithin(limit), twin.plane <= t * t) << i;
      ASSERT_EQ(near.IsFootWithin(limit), twin.foot <= t * t) << i;
      ASSERT_EQ(near.IsWithin(t), twin.distance <= t * t) << i;
      if (t > 0 && twin.plane == t * t) ++plane_ties[0];
      if (t > 0 && twin.foot == t * t) ++foot_ties;
    }
    ASSERT_EQ(static_cast<int>(near.ComparePlanes(other)),
              SignOfDifference(twin.plane, other_twin.plane))
        << i;
    ASSERT_EQ(static_cast<int>(near.CompareDistances(other)),
              SignOfDifference(twin.distance, other_twin.distance))
        << i;
    if (twin.plane == other_twin.plane) ++plane_ties[1];
    if (twin.distance == other_twin.distance) ++distance_ties;
    ASSERT_NEAR(near.PlaneDistance(), std::sqrt(twin.plane.get_d()), 1e-14);
    ASSERT_NEAR(near.Distance(), std::sqrt(twin.distance.get_d()), 1e-14);
  }
  for (const int turn : turns)
    EXPECT_GT(turn, count / 100);
  EXPECT_GT(plane_ties[0], count / 100);
  EXPECT_GT(plane_ties[1], count / 100);
  EXPECT_GT(foot_ties, count / 100);
  EXPECT_GT(distance_ties, count / 100);
  EXPECT_GT(behind, count / 10);
}

// Sixty degrees exactly: n = (1, 1, 0), m a multiple of (1, 0, 1).
TEST(NearTriangle, SixtyDegreesAreAlike) {
  const RoundUpward rounding;
  const Corners corners = {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 1}}};
  const Receiver receiver{{0, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(NearTriangle(corners, receiver).TurnOf(), Turn::kAlike);
  const Receiver steeper{{0, 0, 0}, {1, std::nextafter(1, 2), 0}};
  EXPECT_EQ(NearTriangle(corners, steeper).TurnOf(), Turn::kSameSide);
}

// The parts of the default limit, at its end and one step beyond.
TEST(NearTriangle, LimitsAreTheSumOfTheirParts) {
  const RoundUpward rounding;
  const Corners corners = {{{-8, -8, 0}, {8, -8, 0}, {0, 8, 0}}};
  const NearLimit limit{0, 3, -8, 8};
  const double t = 3 * 0x1p-22 + 16 * 0x1p-20;
  for (const double side : {-1.0, 1.0}) {
    const Receiver at{{0, 0, side * t}, {0, 0, 1}};
    const Receiver beyond{{0, 0, side * std::nextafter(t, 1)}, {0, 0, 1}};
    EXPECT_TRUE(NearTriangle(corners, at).IsPlaneWithin(limit));
    EXPECT_FALSE(NearTriangle(corners, beyond).IsPlaneWithin(limit));
  }
}

// Squares of these are beyond binary64's range.
TEST(NearTriangle, DistancesNeedNoRange) {
  const RoundUpward rounding;
  for (const double s : {0x1p-900, 0x1p900}) {
    const Corners corners = {{{0, 0, 0}, {s, 0, 0}, {0, s, 0}}};
    const Receiver receiver{{-3 * s, -4 * s, 0}, {0, 0, 1}};
    EXPECT_EQ(NearTriangle(corners, receiver).Distance(), 5 * s);
    EXPECT_EQ(NearTriangle(corners, receiver).PlaneDistance(), 0);
    const Receiver above{{0, 0, 3 * s}, {0, 0, 1}};
    EXPECT_EQ(NearTriangle(corners, above).PlaneDistance(), 3 * s);
  }
}

}  // namespace
}  // namespace truelux
