// SPDX-License-Identifier: GPL-3.0-or-later
// The staged predicates on inputs made by hand: the sign, and the cheapest
// stage that may answer.

#include <array>
#include <ostream>

#include <gtest/gtest.h>

#include "exact/view_geometry.h"
#include "support/view_fixture.h"

namespace truelux {
namespace {

using Fixture = testing::ViewFixture;

enum class Stage { kFilter, kInterval, kDoubled, kExact };

void ExpectStage(const StageCounts& counts, Stage stage) {
  EXPECT_EQ(counts.filter, stage == Stage::kFilter ? 1U : 0U);
  EXPECT_EQ(counts.interval, stage == Stage::kInterval ? 1U : 0U);
  EXPECT_EQ(counts.double_double, stage == Stage::kDoubled ? 1U : 0U);
  EXPECT_EQ(counts.exact, stage == Stage::kExact ? 1U : 0U);
}

constexpr double kUlp = 0x1p-52;

/// Coordinates of about 40 bits: sums are exact, products are not.
constexpr double kA = 1 + 0x1p-39;
constexpr double kB = 3 - 0x1p-38;
constexpr double kC = 5 + 0x1p-37;

struct ReceiverCase {
  const char* what;
  Point3 receiver;
  std::array<Point3, 3> corners;
  Sign sign;
  Stage stage;
};

void PrintTo(const ReceiverCase& c, std::ostream* out) {
  *out << c.what;
}

class ReceiverSideCoverage : public ::testing::TestWithParam<ReceiverCase> {};

TEST_P(ReceiverSideCoverage, HasSignAtCheapestStage) {
  const ReceiverCase& c = GetParam();
  Fixture f;
  f.position = c.receiver;
  f.AddTriangle(c.corners[0], c.corners[1], c.corners[2]);
  const RoundUpward rounding;
  ViewGeometry g = f.Make();
  EXPECT_EQ(g.ReceiverSide(TriangleId(0)), c.sign) << c.what;
  ExpectStage(g.statistics().receiver_side, c.stage);
  EXPECT_EQ(g.ReceiverSideExact(TriangleId(0)), c.sign);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ReceiverSideCoverage,
    ::testing::Values(
        ReceiverCase{"normal points away",
                     {0, 0, 0},
                     {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
                     Sign::kPositive,
                     Stage::kFilter},
        ReceiverCase{"r in front",
                     {0, 0, 0},
                     {{{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}},
                     Sign::kNegative,
                     Stage::kFilter},
        ReceiverCase{"in the plane, few bits",
                     {1, 2, 3},
                     {{{2, 4, 6}, {3, 1, 5}, {0, 5, 4}}},
                     Sign::kZero,
                     Stage::kInterval},
        ReceiverCase{"in the plane, many bits",
                     {kA, kB, kC},
                     {{{kA + kB, kB + kC, kC + kA},
                       {kA + kC, kB + kB, kC + kC},
                       {kA + kB + kC, kB + kC + kB, kC + kA + kC}}},
                     Sign::kZero,
                     Stage::kExact},
        ReceiverCase{
            "the same, one ulp off",
            {kA, kB, kC},
            {{{kA + kB, kB + kC, kC + kA},
              {kA + kC, kB + kB, kC + kC},
              {kA + kB + kC, kB + kC + kB, (kC + kA + kC) * (1 + kUlp)}}},
            Sign::kNegative,
            Stage::kDoubled},
        ReceiverCase{"products underflow",
                     {0, 0, 0},
                     {{{0, 0, 0x1p-600},
                       {0x1p-600, 0, 0x1p-600},
                       {0, 0x1p-600, 0x1p-600}}},
                     Sign::kPositive,
                     Stage::kExact},
        ReceiverCase{
            "products overflow",
            {0, 0, 0},
            {{{0, 0, 0x1p600}, {0x1p600, 0, 0x1p600}, {0, 0x1p600, 0x1p600}}},
            Sign::kPositive,
            Stage::kInterval}));

struct OrderCase {
  const char* what;
  std::array<Point3, 2> first;  ///< edge whose plane is crossed
  std::array<Point3, 2> second;
  Sign sign;
  Stage stage;
};

void PrintTo(const OrderCase& c, std::ostream* out) {
  *out << c.what;
}

class EdgeOrderCoverage : public ::testing::TestWithParam<OrderCase> {};

/// The edge runs along x at (x, 0, 1), x = -8 .. 8.
TEST_P(EdgeOrderCoverage, HasSignAtCheapestStage) {
  const OrderCase& c = GetParam();
  Fixture f;
  f.vertices = {{-8, 0, 1}, {8, 0, 1},   c.first[0],
                c.first[1], c.second[0], c.second[1]};
  const RoundUpward rounding;
  ViewGeometry g = f.Make();
  const auto u = g.VertexDirection(VertexId(0));
  const auto v = g.VertexDirection(VertexId(1));
  const auto edge = [&g](int a, int b) {
    return g.AddPlane(PlaneRecipe::OfEdge(VertexId(a), VertexId(b)));
  };
  const ViewPlaneId n = edge(0, 1);
  const auto crossing = [&](ViewPlaneId plane) {
    return MakeCrossing(plane, g.PlaneSide(plane, u), g.PlaneSide(plane, v));
  };
  const Crossing a = crossing(edge(2, 3));
  const Crossing b = crossing(edge(4, 5));
  EXPECT_EQ(g.EdgeOrder(n, a, b), c.sign) << c.what;
  ExpectStage(g.statistics().edge_order, c.stage);
  EXPECT_EQ(g.EdgeOrderExact(n, a, b), c.sign);
  // Antisymmetry, and independence of the direction of the crossed edge.
  EXPECT_EQ(g.EdgeOrder(n, b, a), -c.sign);
  EXPECT_EQ(g.EdgeOrder(n, crossing(edge(3, 2)), b), c.sign);
  EXPECT_EQ(g.EdgeOrderExact(n, a, crossing(edge(5, 4))), c.sign);
}

constexpr double kX = 1 + 0x1p-30;  // 31 bits; its multiples below are exact

INSTANTIATE_TEST_SUITE_P(
    Cases, EdgeOrderCoverage,
    ::testing::Values(OrderCase{"left of",
                                {{{-1, -1, 1}, {-1, 1, 1}}},
                                {{{2, -1, 1}, {2, 1, 1}}},
                                Sign::kNegative,
                                Stage::kFilter},
                      OrderCase{"right of, crossed downwards",
                                {{{3, 1, 1}, {3, -1, 1}}},
                                {{{2, -1, 1}, {2, 1, 1}}},
                                Sign::kPositive,
                                Stage::kFilter},
                      OrderCase{"same point, other depth and slope",
                                {{{1, -1, 1}, {1, 1, 1}}},
                                {{{4, -2, 2}, {0, 2, 2}}},
                                Sign::kZero,
                                Stage::kInterval},
                      OrderCase{"same point, many bits",
                                {{{kX, -kX, 1}, {kX, kX * 3, 1}}},
                                {{{kX * 5, -kX * 3, 2}, {-kX, kX * 3, 2}}},
                                Sign::kZero,
                                Stage::kExact},
                      OrderCase{"the same, one ulp off",
                                {{{kX * (1 + kUlp), -kX, 1},
                                  {kX * (1 + kUlp), kX * 3, 1}}},
                                {{{kX * 5, -kX * 3, 2}, {-kX, kX * 3, 2}}},
                                Sign::kPositive,
                                Stage::kDoubled}));

}  // namespace
}  // namespace truelux
