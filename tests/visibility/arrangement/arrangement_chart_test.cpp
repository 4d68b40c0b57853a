// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_chart.h"

#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

const std::vector<Vector3>& Normals() {
  static const std::vector<Vector3> normals = {{0, 0, 1},
                                               {0, -1, 0},
                                               {1, 0, 0},
                                               {1, 1, 1},
                                               {-3, 2, -7},
                                               {0.1, -0.2, 0.3},
                                               {1e300, 1, -1e-300},
                                               {5e-324, 0, 0},
                                               {0, -5e-324, 5e-324},
                                               {1e308, 1e308, -1e308}};
  return normals;
}

Vec3<Exact> ExactOf(const Vector3& v) {
  return {v.x, v.y, v.z};
}

Vec3<Exact> RandomVector(PortableRandom& random) {
  return {random.Integer(-9, 9), random.Integer(-9, 9), random.Integer(-9, 9)};
}

Sign SideOf(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return SignOf(Dot(a, b));
}

bool IsZero(const Vec3<Exact>& v) {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

bool SameDirection(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return IsZero(Cross(a, b)) && SideOf(a, b) == Sign::kPositive;
}

/// Twice the signed area of a polygon of the image, up to a positive factor
/// per term; its sign is that of each term for a convex polygon.
Sign TurnOf(const ImageDirection& a, const ImageDirection& b,
            const ImageDirection& c) {
  return SignOf(Determinant(a, b, c));
}

ImageDirection DirectionOf(const ImagePoint& p) {
  return {p.x, p.y, p.w};
}

TEST(ViewChart, ImageOfAConeIsTheUnitTriangle) {
  PortableRandom random(1);
  int points = 0;
  for (const Vector3& normal : Normals()) {
    const auto charts = ViewChartsOf(normal);
    for (int i = 0; i < 50; ++i) {
      const std::array<Vec3<Exact>, 3> triangle = {
          RandomVector(random), RandomVector(random), RandomVector(random)};
      if (Determinant(triangle[0], triangle[1], triangle[2]).is_zero()) {
        continue;  // its plane contains r
      }
      for (const ViewChart& chart : charts) {
        for (const WorldPoint& p : chart.Clip(triangle)) {
          const ImagePoint q = chart.ImageFromWorld(p);
          EXPECT_GE(q.x, Exact(0));
          EXPECT_GE(q.y, Exact(0));
          EXPECT_LE(q.x + q.y, q.w);
          EXPECT_GT(q.w, Exact(0));
          ++points;
        }
      }
    }
  }
  EXPECT_GT(points, 1000);
}

TEST(ViewChart, WorldFromImageUndoesImageFromWorld) {
  PortableRandom random(2);
  int seen = 0;
  for (const Vector3& normal : Normals()) {
    for (const ViewChart& chart : ViewChartsOf(normal)) {
      for (int i = 0; i < 50; ++i) {
        const std::array<Vec3<Exact>, 3> triangle = {
            RandomVector(random), RandomVector(random), RandomVector(random)};
        if (Determinant(triangle[0], triangle[1], triangle[2]).is_zero()) {
          continue;
        }
        for (const WorldPoint& p : chart.Clip(triangle)) {
          const ImageDirection d = DirectionOf(chart.ImageFromWorld(p));
          EXPECT_TRUE(SameDirection(chart.WorldFromImage(d), p.offset));
          ++seen;
        }
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

TEST(ViewChart, LeftInTheImageIsLeftForTheReceiver) {
  for (const Vector3& normal : Normals()) {
    for (const ViewChart& chart : ViewChartsOf(normal)) {
      const Exact zero(0);
      const Exact one(1);
      const ImageDirection a{zero, zero, one};
      const ImageDirection b{one, zero, one};
      const ImageDirection c{zero, one, one};
      ASSERT_EQ(TurnOf(a, b, c), Sign::kPositive);
      EXPECT_EQ(
          SignOf(Determinant(chart.WorldFromImage(a), chart.WorldFromImage(b),
                             chart.WorldFromImage(c))),
          Sign::kPositive);
    }
  }
}

// A triangle above the horizon has the sum of its parts' solid-angle-like
// weights det(a, b, c) as its own: here det is additive because all parts lie
// in one plane.
TEST(ViewChart, TheConesPartitionTheHemisphere) {
  PortableRandom random(3);
  int split = 0;
  for (const Vector3& normal : Normals()) {
    const Vec3<Exact> n = ExactOf(normal);
    const auto charts = ViewChartsOf(normal);
    for (int i = 0; i < 100; ++i) {
      const std::array<Vec3<Exact>, 3> triangle = {
          RandomVector(random), RandomVector(random), RandomVector(random)};
      const Exact whole = Determinant(triangle[0], triangle[1], triangle[2]);
      bool above = true;
      for (const Vec3<Exact>& corner : triangle) {
        above = above && SideOf(n, corner) != Sign::kNegative;
      }
      if (whole.is_zero() || !above) continue;
      // parts / denominator is the sum of det over the parts' triangles.
      Exact parts(0);
      Exact denominator(1);
      int cones = 0;
      for (const ViewChart& chart : charts) {
        const std::vector<WorldPoint> polygon = chart.Clip(triangle);
        cones += polygon.empty() ? 0 : 1;
        for (std::size_t k = 2; k < polygon.size(); ++k) {
          const WorldPoint& a = polygon[0];
          const WorldPoint& b = polygon[k - 1];
          const WorldPoint& c = polygon[k];
          const Exact scale = a.scale * b.scale * c.scale;
          parts = parts * scale +
                  Determinant(a.offset, b.offset, c.offset) * denominator;
          denominator = denominator * scale;
        }
      }
      EXPECT_EQ(parts, whole * denominator);
      split += cones > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(split, 50);
}

TEST(ViewChart, ATriangleThatOnlyTouchesAConeIsNotInIt) {
  const auto charts = ViewChartsOf({0, 0, 1});
  const auto parts = [&](const std::array<Vec3<Exact>, 3>& triangle) {
    int count = 0;
    for (const ViewChart& chart : charts)
      count += chart.Clip(triangle).empty() ? 0 : 1;
    return count;
  };
  // An edge, then a corner, in the receiver plane, the rest below.
  EXPECT_EQ(parts({{{1, 0, 0}, {0, 1, 0}, {1, 1, -1}}}), 0);
  EXPECT_EQ(parts({{{1, 1, 0}, {0, 1, -1}, {1, 0, -1}}}), 0);
  // An edge in a cut, the rest in one cone.
  EXPECT_EQ(parts({{{1, 0, 1}, {1, 0, 2}, {2, 1, 1}}}), 1);
  // Around the normal: in all four.
  EXPECT_EQ(parts({{{3, 0, 1}, {-2, 2, 1}, {-2, -3, 1}}}), 4);
}

TEST(ViewChart, DirectionsStayNearOneForAnyLengthOfTheNormal) {
  const Exact half(0.5);
  for (const Vector3& normal : Normals()) {
    for (const ViewChart& chart : ViewChartsOf(normal)) {
      const Vec3<Exact> d = chart.WorldFromImage({half * half, half, Exact(1)});
      EXPECT_GT(Dot(d, d), Exact(1e-6));
      EXPECT_LT(Dot(d, d), Exact(1e6));
    }
  }
}

}  // namespace
}  // namespace truelux
