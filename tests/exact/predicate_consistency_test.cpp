// SPDX-License-Identifier: GPL-3.0-or-later
// The staged predicates on random input: agreement of the stages on near ties,
// identities, and how often the exact stage is reached.

#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "exact/view_geometry.h"
#include "support/portable_random.h"
#include "support/view_fixture.h"

namespace truelux {
namespace {

using testing::PortableRandom;
using Fixture = testing::ViewFixture;

TEST(PlaneSide, IsZeroAtTheEndsOfItsOwnEdge) {
  PortableRandom random(3);
  for (int i = 0; i < 500; ++i) {
    Fixture f;
    f.position = {random.Uniform(-1, 1), random.Uniform(-1, 1), 0.1};
    for (int k = 0; k < 2; ++k) {
      f.vertices.push_back(
          {random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(1, 2)});
    }
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const ViewPlaneId plane =
        g.AddPlane(PlaneRecipe::OfEdge(VertexId(0), VertexId(1)));
    for (const int vertex : {0, 1}) {
      const auto d = g.VertexDirection(VertexId(vertex));
      EXPECT_EQ(g.PlaneSide(plane, d).sign, Sign::kZero);
      EXPECT_EQ(g.PlaneSideExact(plane, d), Sign::kZero);
    }
    EXPECT_EQ(g.statistics().plane_side.symbolic, 2U);
  }
}

TEST(PlaneSide, ClippedEndsLieExactlyOnTheClippingPlane) {
  PortableRandom random(4);
  for (int i = 0; i < 200; ++i) {
    Fixture f;
    f.position = {random.Uniform(-1, 1), random.Uniform(-1, 1),
                  random.Uniform(-1, 1)};
    f.normal = {random.Uniform(-1, 1), random.Uniform(-1, 1), 1};
    f.AddTriangle({random.Uniform(-1, 1), random.Uniform(-1, 1), 9},
                  {random.Uniform(-1, 1), random.Uniform(-1, 1), -9},
                  {random.Uniform(2, 3), random.Uniform(-1, 1), 0.5});
    // A plane between the heights of vertices 0 and 1.
    f.AddTriangle({5, 1, random.Uniform(-1, 1)}, {-5, 1, random.Uniform(-1, 1)},
                  {0, -5, random.Uniform(-1, 1)});
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const auto horizon = g.AddPlane(PlaneRecipe::OfHorizon());
    const auto up = g.AddDirection(
        DirectionRecipe::EdgeAtHorizon(VertexId(0), VertexId(1)));
    EXPECT_EQ(g.PlaneSide(horizon, up).sign, Sign::kZero);
    const bool front =
        g.VertexSide(TriangleId(1), VertexId(0)) == Sign::kPositive;
    const auto cut_end = g.AddDirection(DirectionRecipe::EdgeAtPlane(
        VertexId(front ? 0 : 1), VertexId(front ? 1 : 0), TriangleId(1)));
    const auto cut =
        g.AddPlane(PlaneRecipe::OfCut(TriangleId(1), TriangleId(0)));
    const auto edge = g.AddPlane(PlaneRecipe::OfEdge(VertexId(0), VertexId(1)));
    EXPECT_EQ(g.PlaneSide(cut, cut_end).sign, Sign::kZero);
    EXPECT_EQ(g.PlaneSide(edge, cut_end).sign, Sign::kZero);
    EXPECT_EQ(g.PlaneSide(edge, up).sign, Sign::kZero);
    EXPECT_EQ(g.statistics().plane_side.symbolic, 4U);
    for (const auto& [plane, end] : {std::pair{horizon, up},
                                     {cut, cut_end},
                                     {edge, cut_end},
                                     {edge, up}}) {
      EXPECT_EQ(g.PlaneSideExact(plane, end), Sign::kZero);
    }
  }
}

/// A direction almost in the plane of an edge: a combination of its ends,
/// rounded, and nudged.
TEST(PlaneSide, StagesAgreeOnNearTies) {
  PortableRandom random(5);
  StageCounts total;
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    Fixture f;
    const bool lattice = i % 2 == 0;
    const auto coordinate = [&] {
      return lattice ? random.Integer(-4, 4) + 0.0 : random.Uniform(-4, 4);
    };
    const Point3 a{coordinate(), coordinate(), coordinate()};
    const Point3 b{coordinate(), coordinate(), coordinate()};
    const double s = lattice ? random.Integer(-2, 2) : random.Uniform(-1, 1);
    const double t = lattice ? random.Integer(-2, 2) : random.Uniform(-1, 1);
    Point3 c{s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
    if (i % 3 == 0) c.y = random.Nudge(c.y);
    if (i % 5 == 0) c.z += 0x1p-40;
    f.vertices = {a, b, c};
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const ViewPlaneId plane =
        g.AddPlane(PlaneRecipe::OfEdge(VertexId(0), VertexId(1)));
    const auto d = g.VertexDirection(VertexId(2));
    const Sign exact = g.PlaneSideExact(plane, d);
    if (const auto sign = g.PlaneSideInterval(plane, d)) {
      ASSERT_EQ(*sign, exact) << "sample " << i;
    }
    if (const auto sign = g.PlaneSideDoubled(plane, d)) {
      ASSERT_EQ(*sign, exact) << "sample " << i;
    }
    if (const auto sign = TrySign(g.PlaneSideFilter(plane, d))) {
      ASSERT_EQ(*sign, exact) << "sample " << i;
    }
    EXPECT_EQ(g.PlaneSide(plane, d).sign, exact);
    zeros += exact == Sign::kZero ? 1 : 0;
    total += g.statistics().plane_side;
  }
  EXPECT_GT(zeros, 2000);
  EXPECT_GT(total.filter, 500U);
  EXPECT_GT(total.interval, 2000U);
  EXPECT_GT(total.double_double, 1000U);
  EXPECT_GT(total.exact, 50U);
}

TEST(EdgeOrder, StagesAgreeOnNearTiesAndAreTransitive) {
  PortableRandom random(6);
  StageCounts total;
  int zeros = 0;
  for (int i = 0; i < 4000; ++i) {
    Fixture f;
    f.vertices = {{-8, 0.25, 1}, {8, -0.5, 1}};
    const bool lattice = i % 2 == 0;
    const double x = lattice ? random.Integer(-3, 3) : random.Uniform(-3, 3);
    for (int k = 0; k < 3; ++k) {  // edges through (almost) one image point
      const double depth =
          lattice ? random.Integer(1, 4) : random.Uniform(0.5, 2);
      const double dx = lattice ? random.Integer(-2, 2) : random.Uniform(-2, 2);
      const double dy = lattice ? random.Integer(1, 3) : random.Uniform(1, 3);
      const double y = 0.25 - 0.75 * (x + 8) / 16;
      f.vertices.push_back({(x + dx) * depth, (y + dy) * depth, depth});
      const double off = i % 5 == 0 ? k * 0x1p-30 : 0.0;
      f.vertices.push_back(
          {random.Nudge((x - dx) * depth + off), (y - dy) * depth, depth});
    }
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const auto u = g.VertexDirection(VertexId(0));
    const auto v = g.VertexDirection(VertexId(1));
    const auto n = g.AddPlane(PlaneRecipe::OfEdge(VertexId(0), VertexId(1)));
    std::array<Crossing, 3> c;
    bool proper = true;
    for (int k = 0; k < 3; ++k) {
      const auto p = g.AddPlane(
          PlaneRecipe::OfEdge(VertexId(2 + 2 * k), VertexId(3 + 2 * k)));
      Crossing& crossing = c[static_cast<std::size_t>(k)];
      const Side from = g.PlaneSide(p, u);
      const Side to = g.PlaneSide(p, v);
      crossing = MakeCrossing(p, from, to);
      proper = proper && from.sign * to.sign == Sign::kNegative;
    }
    if (!proper) continue;
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
      const Crossing& ca = c[static_cast<std::size_t>(a)];
      const Crossing& cb = c[static_cast<std::size_t>(b)];
      const Sign exact = g.EdgeOrderExact(n, ca, cb);
      if (const auto s = TryOrder(ca, cb)) {
        ASSERT_EQ(*s, exact) << "sample " << i;
      }
      if (const auto s = g.EdgeOrderInterval(n, ca, cb)) {
        ASSERT_EQ(*s, exact) << "sample " << i;
      }
      if (const auto s = g.EdgeOrderDoubled(n, ca, cb)) {
        ASSERT_EQ(*s, exact) << "sample " << i;
      }
      zeros += exact == Sign::kZero ? 1 : 0;
    }
    const Sign ab = g.EdgeOrder(n, c[0], c[1]);
    const Sign bc = g.EdgeOrder(n, c[1], c[2]);
    const Sign ac = g.EdgeOrder(n, c[0], c[2]);
    if (ab == bc) {
      EXPECT_EQ(ac, ab) << "sample " << i;
    }
    total += g.statistics().edge_order;
  }
  EXPECT_GT(zeros, 500);
  EXPECT_GT(total.filter, 100U);
  EXPECT_GT(total.interval, 100U);
  EXPECT_GT(total.double_double, 100U);
  EXPECT_GT(total.exact, 100U);
}

TEST(EdgeOrder, GenericInputNeverReachesTheExactStage) {
  PortableRandom random(7);
  StageCounts order;
  StageCounts side;
  for (int i = 0; i < 5000; ++i) {
    Fixture f;
    f.position = {random.Uniform(-1, 1), random.Uniform(-1, 1), 0};
    for (int k = 0; k < 6; ++k) {
      f.vertices.push_back(
          {random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(1, 2)});
    }
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const auto u = g.VertexDirection(VertexId(0));
    const auto v = g.VertexDirection(VertexId(1));
    bool proper = true;
    const auto crossing = [&](int a) {
      const auto p =
          g.AddPlane(PlaneRecipe::OfEdge(VertexId(a), VertexId(a + 1)));
      const Side from = g.PlaneSide(p, u);
      const Side to = g.PlaneSide(p, v);
      proper = proper && from.sign * to.sign == Sign::kNegative;
      return MakeCrossing(p, from, to);
    };
    const auto n = g.AddPlane(PlaneRecipe::OfEdge(VertexId(0), VertexId(1)));
    const Crossing a = crossing(2);
    const Crossing b = crossing(4);
    if (proper) g.EdgeOrder(n, a, b);
    order += g.statistics().edge_order;
    side += g.statistics().plane_side;
  }
  EXPECT_GT(order.filter, 500U);
  EXPECT_EQ(order.exact, 0U);
  EXPECT_EQ(side.exact, 0U);
  EXPECT_LT(side.interval, side.filter / 100);
}

TEST(VertexSide, IsZeroForOwnCornersAndIndependentOfTheReceiver) {
  PortableRandom random(8);
  for (int i = 0; i < 300; ++i) {
    Fixture f;
    const auto point = [&random] {
      return Point3{random.Uniform(-1, 1), random.Uniform(-1, 1),
                    random.Uniform(-1, 1)};
    };
    f.AddTriangle(point(), point(), point());
    f.vertices.push_back(point());
    const RoundUpward rounding;
    ViewGeometry first = f.Make();
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(first.VertexSide(TriangleId(0), VertexId(k)), Sign::kZero);
    }
    const Sign side = first.VertexSide(TriangleId(0), VertexId(3));
    f.position = point();
    EXPECT_EQ(f.Make().VertexSide(TriangleId(0), VertexId(3)), side);
    EXPECT_EQ(first.VertexSideExact(TriangleId(0), VertexId(3)), side);
  }
}

}  // namespace
}  // namespace truelux
