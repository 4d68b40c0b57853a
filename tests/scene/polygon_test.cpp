// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "scene/integer_ring.h"

namespace truelux {
namespace {

using Ring = std::vector<Point3>;

PolygonKind KindOf(const Ring& ring) {
  return PolygonReader().Read(ring);
}

Ring Scaled(Ring ring, int exponent) {
  for (Point3& p : ring) {
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent),
         std::ldexp(p.z, exponent)};
  }
  return ring;
}

const Ring kSquare{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};

TEST(Polygon, PointsOnOneLineHaveNoArea) {
  EXPECT_EQ(KindOf({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}), PolygonKind::kNoArea);
  EXPECT_EQ(KindOf({{0, 0, 0}, {3, 6, 9}, {1, 2, 3}, {2, 4, 6}}),
            PolygonKind::kNoArea);
  EXPECT_EQ(KindOf({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {2, 0, 0}}),
            PolygonKind::kNoArea);
}

TEST(Polygon, AnUlpOffALineIsATriangle) {
  const double up = std::nextafter(6.0, 7.0);
  EXPECT_EQ(KindOf({{0, 0, 0}, {1, 2, 3}, {2, 4, up}}), PolygonKind::kPlanar);
}

TEST(Polygon, ASymmetricBowTieIsNoPolygon) {
  EXPECT_EQ(KindOf({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
            PolygonKind::kNoPolygon);
}

TEST(Polygon, WithoutANormalAndNotPlanarItIsTheFan) {
  PolygonReader reader;
  EXPECT_EQ(reader.Read(Ring{{0, 0, 0},
                             {1, 0, 1},
                             {0, 1, -1},
                             {1, 1, 2},
                             {0, 0, 1},
                             {0, 2, -3},
                             {3, 1, 1}}),
            PolygonKind::kNotPlanar);
}

TEST(Polygon, ABoundaryThatMeetsItselfMayBeThatOfAPolygon) {
  // Crossing.
  EXPECT_EQ(KindOf({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {3, 3, 0}}),
            PolygonKind::kNoPolygon);
  // Pinch: a vertex on another edge.
  EXPECT_EQ(KindOf({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}),
            PolygonKind::kPlanar);
  // Pinch: a vertex on another vertex.
  EXPECT_EQ(
      KindOf(
          {{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}),
      PolygonKind::kPlanar);
  // Spike along an edge.
  EXPECT_EQ(KindOf({{0, 0, 0}, {6, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}),
            PolygonKind::kPlanar);
  // Keyhole: a hole joined to the border by a bridge.
  EXPECT_EQ(KindOf({{0, 0, 0},
                    {9, 0, 0},
                    {9, 9, 0},
                    {0, 9, 0},
                    {0, 0, 0},
                    {3, 3, 0},
                    {3, 6, 0},
                    {6, 6, 0},
                    {6, 3, 0},
                    {3, 3, 0}}),
            PolygonKind::kPlanar);
  // Edges that overlap without a common vertex.
  EXPECT_EQ(KindOf({{0, 0, 0},
                    {6, 0, 0},
                    {6, 4, 0},
                    {4, 4, 0},
                    {4, 0, 0},
                    {2, 0, 0},
                    {2, 4, 0},
                    {0, 4, 0}}),
            PolygonKind::kPlanar);
  // Twice around.
  EXPECT_EQ(
      KindOf(
          {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}),
      PolygonKind::kNoPolygon);
}

TEST(Polygon, ARingThatIsNotPlanarAndCrossesItselfIsTheFan) {
  PolygonReader reader;
  ASSERT_EQ(reader.Read(Ring{{0, 0, 0}, {4, 0, 1}, {1, 3, 0}, {3, 3, 0}}),
            PolygonKind::kNotPlanar);
  ASSERT_EQ(reader.triangles().size(), 2U);
  EXPECT_EQ(reader.triangles()[0], (RingTriangle{0, 1, 2}));
  EXPECT_EQ(reader.triangles()[1], (RingTriangle{0, 2, 3}));
}

TEST(Polygon, NamesTheEdgesThatMeet) {
  PolygonReader reader;
  ASSERT_EQ(reader.Read(Ring{{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {3, 3, 0}}),
            PolygonKind::kNoPolygon);
  EXPECT_EQ(reader.contact().first_edge, 1);
  EXPECT_EQ(reader.contact().second_edge, 3);
}

TEST(Polygon, AStraightVertexIsNoContact) {
  EXPECT_EQ(KindOf({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}),
            PolygonKind::kPlanar);
}

TEST(Polygon, AnUlpOutOfThePlaneIsNotPlanar) {
  Ring ring = kSquare;
  EXPECT_EQ(KindOf(ring), PolygonKind::kPlanar);
  ring[2].z = std::nextafter(0.0, 1.0);
  EXPECT_EQ(KindOf(ring), PolygonKind::kNotPlanar);
  // In a slanted plane no coordinate tells, and the products round.
  Ring slanted{{0.1, 0.2, 0}, {1.1, 0.2, 0}, {1.1, 7.7, 0}, {0.1, 7.7, 0}};
  for (Point3& p : slanted)
    p.z = p.y;
  EXPECT_EQ(KindOf(slanted), PolygonKind::kPlanar);
  slanted[1].z = std::nextafter(slanted[1].z, 1.0);
  EXPECT_EQ(KindOf(slanted), PolygonKind::kNotPlanar);
}

TEST(Polygon, TheKindDoesNotDependOnTheScale) {
  std::mt19937_64 random(7);
  PolygonReader reader;
  for (int i = 0; i < 300; ++i) {
    const Ring ring =
        RandomIntegerRing(random, 4 + random() % 4, 5, random() % 2 == 0)
            .Points();
    const PolygonKind kind = KindOf(ring);
    for (const int exponent : {-1074, -600, -200, 300, 900, 1019}) {
      ASSERT_EQ(reader.Read(Scaled(ring, exponent)), kind) << exponent;
    }
  }
}

TEST(Polygon, PointsOnALineOfTheImageAreSeenToBeAtEveryScale) {
  // Both have the normal (0, 0, z) without being planar.
  const Ring middles_raised{{0, 0, 0}, {2, 0, 1}, {4, 0, 0},
                            {4, 4, 0}, {2, 4, 1}, {0, 4, 0}};
  const Ring two_edges_on_one_line{{0, 0, 1}, {6, 0, 1}, {6, 4, 3}, {4, 4, 0},
                                   {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 3}};
  PolygonReader reader;
  for (const Ring& ring : {middles_raised, two_edges_on_one_line}) {
    for (const int exponent : {-1074, -700, 0, 300, 900}) {
      Ring turned = Scaled(ring, exponent);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(reader.Read(turned), PolygonKind::kNotPlanar) << exponent;
        std::ranges::reverse(turned);
        EXPECT_EQ(reader.Read(turned), PolygonKind::kNotPlanar) << exponent;
        for (Point3& p : turned)
          p = {p.y, p.z, p.x};
      }
    }
  }
}

TEST(Polygon, ExponentsMayDifferByTwoThousandBits) {
  const double huge = std::ldexp(1, 1023);
  const double tiny = std::ldexp(1, -1074);
  EXPECT_EQ(KindOf({{0, 0, 0}, {huge, 0, 0}, {huge, tiny, 0}}),
            PolygonKind::kPlanar);
  EXPECT_EQ(KindOf({{0, 0, 0}, {huge, 0, 0}, {huge, tiny, 0}, {0, tiny, 0}}),
            PolygonKind::kPlanar);
  EXPECT_EQ(KindOf({{0, 0, 0}, {huge, 0, 0}, {huge, tiny, tiny}, {0, tiny, 0}}),
            PolygonKind::kNotPlanar);
  EXPECT_EQ(KindOf({{-huge, -huge, 0}, {huge, huge, 0}, {tiny, tiny, 0}}),
            PolygonKind::kNoArea);
  EXPECT_EQ(KindOf({{-huge, -huge, 0}, {huge, huge, 0}, {tiny, 0, 0}}),
            PolygonKind::kPlanar);
  EXPECT_EQ(KindOf({{0, 0, 0}, {huge, 0, 0}, {1, tiny, 0}, {2, -tiny, 0}}),
            PolygonKind::kNoPolygon);
}

}  // namespace
}  // namespace truelux
