// SPDX-License-Identifier: GPL-3.0-or-later
// The double-double stage of each predicate: it tells near-ties from ties where
// nothing over- or underflows, and never says what is not so.
#include "exact/doubled.h"

#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "exact/rounding.h"
#include "exact/view_geometry.h"
#include "support/portable_random.h"
#include "support/view_fixture.h"

namespace truelux {
namespace {

using testing::PortableRandom;
using Fixture = testing::ViewFixture;

/// What the stage said over many samples, beside the exact sign.
struct Tally {
  int ties = 0;
  int near_ties = 0;
  int answered = 0;  ///< of the near-ties

  void Take(std::optional<Sign> sign, Sign exact) {
    (exact == Sign::kZero ? ties : near_ties)++;
    if (!sign) return;
    // No bound excludes zero where zero is the truth.
    EXPECT_EQ(*sign, exact);
    ++answered;
  }
};

/// Four points of a plane, up to the rounding of binary64, and its corners of
/// which one is nudged at times. At a scale 2^exponent.
struct NearPlane {
  NearPlane(PortableRandom& random, int exponent, bool is_tie) {
    const double scale = std::ldexp(1.0, exponent);
    // Of few bits, so that sums are exact and all ties remain.
    const auto number = [&] {
      return std::ldexp(random.Integer(-(1 << 20), 1 << 20), -18);
    };
    const auto point = [&] { return Point3{number(), number(), number()}; };
    const Point3 a = point();
    const Point3 u = point();
    const Point3 v = point();
    const auto at = [&](double s, double t) {
      return Point3{a.x + s * u.x + t * v.x, a.y + s * u.y + t * v.y,
                    a.z + s * u.z + t * v.z};
    };
    // All exact in binary64: at most 26 bits.
    points[0] = at(0, 0);
    points[1] = at(3, -1);
    points[2] = at(-2, 5);
    points[3] = at(4, 4);
    if (!is_tie) points[3].y = random.Nudge(points[3].y);
    for (Point3& p : points)
      p = {p.x * scale, p.y * scale, p.z * scale};
  }

  Point3 points[4];
};

constexpr int kSamples = 2000;

/// By scale: what ReceiverSide, VertexSide and PlaneSide say of points that
/// (almost) lie in one plane.
void TakeSides(int exponent, Tally& receiver, Tally& vertex, Tally& plane) {
  PortableRandom random(11);
  for (int i = 0; i < kSamples; ++i) {
    const NearPlane p(random, exponent, i % 4 == 0);
    Fixture f;
    f.AddTriangle(p.points[0], p.points[1], p.points[2]);
    f.vertices.push_back(p.points[3]);
    f.position = p.points[3];
    const RoundUpward rounding;
    const ViewGeometry in_plane = f.Make();
    receiver.Take(in_plane.ReceiverSideDoubled(TriangleId(0)),
                  in_plane.ReceiverSideExact(TriangleId(0)));
    vertex.Take(in_plane.VertexSideDoubled(TriangleId(0), VertexId(3)),
                in_plane.VertexSideExact(TriangleId(0), VertexId(3)));
    f.position = p.points[0];
    ViewGeometry g = f.Make();
    const auto edge = g.AddPlane(PlaneRecipe::OfEdge(VertexId(1), VertexId(2)));
    const auto direction = g.VertexDirection(VertexId(3));
    plane.Take(g.PlaneSideDoubled(edge, direction),
               g.PlaneSideExact(edge, direction));
    EXPECT_TRUE(IsRoundingUpward());
  }
}

/// The same of EdgeOrder: edges that (almost) cross a third one in one point.
void TakeOrders(int exponent, Tally& order) {
  PortableRandom random(12);
  for (int i = 0; i < kSamples; ++i) {
    const double scale = std::ldexp(1.0, exponent);
    const auto integer = [&](int least, int most) {
      return static_cast<double>(random.Integer(least, most));
    };
    const double x = std::ldexp(integer(-(1 << 16), 1 << 16), -15);
    Fixture f;
    f.vertices = {{-8, 0, 1}, {8, 0, 1}};
    for (int k = 0; k < 2; ++k) {
      const double depth = integer(1, 4);
      const double dx = integer(-2, 2);
      const double dy = integer(1, 3);  // so that both cross
      f.vertices.push_back({(x + dx) * depth, dy * depth, depth});
      f.vertices.push_back({(x - dx) * depth, -dy * depth, depth});
    }
    if (i % 4 != 0) f.vertices[2].x = random.Nudge(f.vertices[2].x);
    for (Point3& p : f.vertices)
      p = {p.x * scale, p.y * scale, p.z * scale};
    const RoundUpward rounding;
    ViewGeometry g = f.Make();
    const auto edge = [&g](int a) {
      return g.AddPlane(PlaneRecipe::OfEdge(VertexId(a), VertexId(a + 1)));
    };
    const ViewPlaneId n = edge(0);
    const auto crossing = [&](ViewPlaneId plane) {
      return MakeCrossing(plane,
                          g.PlaneSide(plane, g.VertexDirection(VertexId(0))),
                          g.PlaneSide(plane, g.VertexDirection(VertexId(1))));
    };
    const Crossing a = crossing(edge(2));
    const Crossing b = crossing(edge(4));
    order.Take(g.EdgeOrderDoubled(n, a, b), g.EdgeOrderExact(n, a, b));
    EXPECT_TRUE(IsRoundingUpward());
  }
}

/// Of ReceiverSide, VertexSide, PlaneSide and EdgeOrder at a scale.
std::array<Tally, 4> TalliesAt(int exponent) {
  std::array<Tally, 4> tallies;
  TakeSides(exponent, tallies[0], tallies[1], tallies[2]);
  TakeOrders(exponent, tallies[3]);
  return tallies;
}

TEST(Doubled, TellsNearTiesWhereNothingOverOrUnderflows) {
  // The products of EdgeOrder have degree 6, and 2^-500 is lost at each.
  for (const int exponent : {-40, 0, 40, 120}) {
    for (const Tally& tally : TalliesAt(exponent)) {
      EXPECT_GT(tally.ties, kSamples / 8) << exponent;
      EXPECT_GT(tally.near_ties, kSamples / 3) << exponent;
      EXPECT_EQ(tally.answered, tally.near_ties) << exponent;
    }
  }
}

TEST(Doubled, IsSilentWhereItCannotTell) {
  for (const int exponent : {-1040, -600, -300, 200, 400, 1000}) {
    for (const Tally& tally : TalliesAt(exponent)) {
      EXPECT_LE(tally.answered, tally.near_ties) << exponent;
      if (exponent < -500 || exponent > 350) {
        EXPECT_EQ(tally.answered, 0) << exponent;
      }
    }
  }
}

TEST(Doubled, KeepsTheRoundingModeThatItFinds) {
  Fixture f;
  f.AddTriangle({0, 0, 1}, {0, 1, 1}, {1, 0, 1});
  const ReceiverView view{IdSpan<VertexId, const Point3>(f.vertices),
                          IdSpan<TriangleId, const Triangle>(f.triangles),
                          f.position, f.normal};
  EXPECT_EQ(DoubledHeight(view, TriangleId(0)), Sign::kNegative);
  EXPECT_FALSE(IsRoundingUpward());
  const RoundUpward rounding;
  EXPECT_EQ(DoubledHeight(view, TriangleId(0)), Sign::kNegative);
  EXPECT_TRUE(IsRoundingUpward());
}

}  // namespace
}  // namespace truelux
