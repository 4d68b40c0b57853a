// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/shaft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

constexpr double kMax = std::numeric_limits<double>::max();

/// A source by its ring, convex where it has more than four corners.
struct Source {
  std::vector<Point3> ring;
  std::vector<Triangle> facet;  ///< the fan of the ring

  explicit Source(std::vector<Point3> points) : ring(std::move(points)) {
    for (int i = 2; i < static_cast<int>(ring.size()); ++i)
      facet.push_back({{0, i - 1, i}, 0});
  }

  [[nodiscard]] ShaftSource ForShafts() const { return {ring, facet}; }
};

/// The smallest box around (p + q) / 2. Requires RoundUpward.
Box HalfWay(const Point3& p, const Point3& q) {
  const auto up = [](double a, double b) { return 0.5 * a + 0.5 * b; };
  const auto down = [](double a, double b) { return -(-0.5 * a + -0.5 * b); };
  return {{down(p.x, q.x), down(p.y, q.y), down(p.z, q.z)},
          {up(p.x, q.x), up(p.y, q.y), up(p.z, q.z)}};
}

/// Corner k of a box.
Point3 Corner(const Box& box, std::size_t k) {
  return {(k & 1U) != 0 ? box.hi[0] : box.lo[0],
          (k & 2U) != 0 ? box.hi[1] : box.lo[1],
          (k & 4U) != 0 ? box.hi[2] : box.lo[2]};
}

Point3 RandomPoint(PortableRandom& random, double size) {
  return {random.Uniform(-size, size), random.Uniform(-size, size),
          random.Uniform(-size, size)};
}

/// A source with 3 to 40 corners: a triangle or a quad that is nearly a
/// parallelogram, or an affine image of a regular polygon, nearly.
Source RandomSource(PortableRandom& random, double size) {
  const Point3 a = RandomPoint(random, size);
  const Point3 b = RandomPoint(random, size);
  const Point3 c = RandomPoint(random, size);
  const auto at = [&](double u, double v) {
    return Point3{a.x + u * b.x + v * c.x, a.y + u * b.y + v * c.y,
                  a.z + u * b.z + v * c.z};
  };
  const int count =
      random.OneIn(2) ? 3 + random.Integer(0, 1) : random.Integer(5, 40);
  std::vector<Point3> ring = {at(0, 0), at(1, 0), at(1, 1)};
  if (count == 4) ring.push_back(at(0, 1));
  if (count > 4) {
    ring.clear();
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * 3.14159265358979 * i / count;
      ring.push_back(at(std::cos(angle), std::sin(angle)));
    }
  }
  return Source(ring);
}

bool KeepsAll(const Shaft& shaft, const std::vector<Point3>& points) {
  return std::ranges::all_of(
      points, [&](const Point3& p) { return shaft.Keeps(Box::Of(p)); });
}

bool KeepsAny(const Shaft& shaft, const std::vector<Point3>& points) {
  return std::ranges::any_of(
      points, [&](const Point3& p) { return shaft.Keeps(Box::Of(p)); });
}

/// Whether it keeps the points and those half way between two of them.
bool KeepsHullOf(const std::vector<Point3>& points, const Shaft& shaft) {
  return KeepsAll(shaft, points) &&
         std::ranges::all_of(points, [&](const Point3& p) {
           return std::ranges::all_of(points, [&](const Point3& q) {
             return shaft.Keeps(HalfWay(p, q));
           });
         });
}

TEST(Shaft, ContainsItsHullAtAnyScale) {
  PortableRandom random(1);
  for (int i = 0; i < 5000; ++i) {
    const std::array<int, 7> exponents{0, 0, 300, -300, 1000, -1000, -1060};
    const double size =
        std::ldexp(1, exponents[static_cast<std::size_t>(i % 7)]);
    const Source source = RandomSource(random, size);
    Box receivers = Box::Of(RandomPoint(random, size * 2));
    if (random.OneIn(2)) receivers.Include(RandomPoint(random, size * 2));
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), receivers);
    std::vector<Point3> points = source.ring;
    for (std::size_t k = 0; k < 8; ++k)
      points.push_back(Corner(receivers, k));
    ASSERT_TRUE(KeepsHullOf(points, shaft)) << i;
  }
}

TEST(Shaft, ContainsItsEdgesWhereverTheyPassThroughDoubles) {
  PortableRandom random(6);
  for (int i = 0; i < 20000; ++i) {
    Source source = RandomSource(random, 1);
    // 40 bits, so that a 64th of a coordinate is exact.
    const auto rounded = [](double x) {
      return std::round(x * 0x1p40) / 0x1p40;
    };
    for (Point3& p : source.ring)
      p = {rounded(p.x), rounded(p.y), rounded(p.z)};
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), Box::Of({0, 0, 0}));
    for (const Point3& p : source.ring) {
      const double t = random.Integer(0, 64) / 64.0;
      ASSERT_TRUE(shaft.Keeps(Box::Of({t * p.x, t * p.y, t * p.z}))) << i;
    }
  }
}

TEST(Shaft, KeepsWhatIsAboveTheHorizonOfAReceiver) {
  PortableRandom random(2);
  for (int i = 0; i < 5000; ++i) {
    const double size = std::ldexp(1, 500 * (i % 3 - 1));
    // The normal is at right angles to the line from the receiver to the
    // corner, exactly: integers.
    const auto integer = [&] { return random.Integer(-1000, 1000); };
    const Vector3 d{double(integer()), double(integer()), double(integer())};
    const Vector3 e{double(integer()), double(integer()), double(integer())};
    const Vector3 n{d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z,
                    d.x * e.y - d.y * e.x};
    const Point3 r{double(integer()), double(integer()), double(integer())};
    const auto scaled = [size](double x, double y, double z) {
      return Point3{x * size, y * size, z * size};
    };
    const Source source({scaled(r.x + d.x, r.y + d.y, r.z + d.z),
                         scaled(r.x + e.x, r.y + e.y, r.z + e.z),
                         scaled(r.x + n.x, r.y + n.y, r.z + n.z)});
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), Box::Of(scaled(r.x, r.y, r.z)), n);
    ASSERT_TRUE(KeepsAll(shaft, source.ring)) << i;
    ASSERT_TRUE(shaft.Keeps(Box::Of(scaled(r.x, r.y, r.z)))) << i;
  }
}

/// A lamp over receivers near the origin, at a scale.
Source Lamp(double size) {
  return Source({{-size, -size, 4 * size},
                 {-size, size, 4 * size},
                 {size, size, 4 * size},
                 {size, -size, 4 * size}});
}

class ShaftAtScale : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Exponents, ShaftAtScale,
                         ::testing::Values(0, 300, -300, 1000, -1000));

TEST_P(ShaftAtScale, IsTight) {
  const double size = std::ldexp(1, GetParam());
  const RoundUpward rounding;
  const Shaft shaft(Lamp(size).ForShafts(), Box::Of({0, 0, 0}),
                    Vector3{0, 0, 1});
  const auto all = [size](std::vector<Point3> points) {
    for (Point3& p : points)
      p = {p.x * size, p.y * size, p.z * size};
    return points;
  };
  // The sides are the planes |x| = z / 4 and |y| = z / 4.
  EXPECT_TRUE(KeepsAll(shaft, all({{0.49999, 0, 2},
                                   {-0.49999, 0, 2},
                                   {0, 0.49999, 2},
                                   {0, -0.49999, 2}})));
  EXPECT_FALSE(KeepsAny(shaft, all({{0.50001, 0, 2},
                                    {-0.50001, 0, 2},
                                    {0, 0.50001, 2},
                                    {0, -0.50001, 2},
                                    {0, 0, -0.00001},
                                    {0, 0, 4.00001}})));
}

TEST(Shaft, LeavesOutWhatIsBehindASlantedSource) {
  const Source source({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const RoundUpward rounding;
  const Shaft shaft(source.ForShafts(), Box::Of({1, 1, 1}));
  EXPECT_TRUE(shaft.Keeps(Box::Of({0.34, 0.34, 0.34})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({0.33, 0.33, 0.33})));
}

TEST(Shaft, LeavesOutWhatIsBelowASlantedHorizon) {
  const RoundUpward rounding;
  const Shaft shaft(Lamp(1).ForShafts(), Box::Of({0, 0, 0}),
                    Vector3{1, 0, 0.1});
  EXPECT_TRUE(shaft.Keeps(Box::Of({-0.19, 0, 2})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({-0.21, 0, 2})));
}

TEST(Shaft, OpensForABlockOfReceivers) {
  Box receivers = Box::Of({0, 0, 0});
  receivers.Include(Point3{1, 0, 0});
  const RoundUpward rounding;
  const Shaft shaft(Lamp(1).ForShafts(), receivers);
  EXPECT_TRUE(shaft.Keeps(Box::Of({1, 0, 2})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({0.5, 1.1, 2})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({0.5, 0.51, 1.9})));
}

TEST(Shaft, FitsASourceOfManyCorners) {
  std::vector<Point3> ring;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 12;
    ring.push_back({std::cos(angle), std::sin(angle), 4});
  }
  const RoundUpward rounding;
  const Shaft shaft(Source(ring).ForShafts(), Box::Of({0, 0, 0}));
  EXPECT_TRUE(shaft.Keeps(Box::Of({0, 0, 2})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({0.8, 0, 2})));
  EXPECT_FALSE(shaft.Keeps(Box::Of({0, -0.8, 2})));
}

TEST(Shaft, OverflowOnlyWidensIt) {
  const std::array<double, 3> values{-kMax, 0, kMax};
  PortableRandom random(3);
  const auto value = [&] {
    return values[static_cast<std::size_t>(random.Integer(0, 2))];
  };
  const auto point = [&] { return Point3{value(), value(), value()}; };
  for (int i = 0; i < 5000; ++i) {
    const Source source({point(), point(), point(), point()});
    const Point3 r = point();
    const Point3 n = point();
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), Box::Of(r));
    ASSERT_TRUE(KeepsAll(shaft, source.ring)) << i;
    ASSERT_TRUE(shaft.Keeps(Box::Of(r)));
    if (n == Point3{}) continue;
    const Shaft above(source.ForShafts(), Box::Of(r), Vector3{n.x, n.y, n.z});
    ASSERT_TRUE(above.Keeps(Box::Of(r)));
  }
}

TEST(Shaft, KeepsABoxIfItKeepsAnythingInIt) {
  PortableRandom random(4);
  for (int i = 0; i < 5000; ++i) {
    const Source source = RandomSource(random, 1);
    const Box receiver = Box::Of(RandomPoint(random, 2));
    Box inner = Box::Of(RandomPoint(random, 2));
    inner.Include(RandomPoint(random, 2));
    Box outer = inner;
    outer.Include(RandomPoint(random, 2));
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), receiver, Vector3{1, 2, 3});
    ASSERT_LE(shaft.Keeps(inner), shaft.Keeps(outer)) << i;
  }
}

TEST(Shaft, TestsFourBoxesAsItTestsOne) {
  PortableRandom random(5);
  for (int i = 0; i < 5000; ++i) {
    const Source source = RandomSource(random, 1);
    FourBoxes boxes;
    const int count = random.Integer(0, 4);
    for (int k = 0; k < count; ++k) {
      Box box = Box::Of(RandomPoint(random, 1));
      box.Include(RandomPoint(random, 1));
      boxes.Set(static_cast<std::size_t>(k), box);
    }
    const RoundUpward rounding;
    const Shaft shaft(source.ForShafts(), Box::Of(RandomPoint(random, 2)));
    const unsigned kept = shaft.Kept(boxes);
    for (int k = 0; k < 4; ++k) {
      const bool expected =
          k < count && shaft.Keeps(boxes.Get(static_cast<std::size_t>(k)));
      ASSERT_EQ((kept >> k & 1U) != 0, expected) << i;
    }
  }
}

}  // namespace
}  // namespace truelux
