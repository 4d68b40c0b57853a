// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes stay meshes: triangles match corner to corner, whatever is halved.

#include "isolux/plan_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "isolux/cut_mesh.h"
#include "isolux/lit_floor.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

double AreaOf(const PlanMesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    area += mesh.AreaOf(static_cast<int>(i));
  return area;
}

double LeastAngle(const PlanMesh& mesh) {
  double least = std::numbers::pi;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const auto c = mesh.CornersOf(static_cast<int>(i));
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanPoint u = c[(k + 1) % 3] - c[k];
      const PlanPoint v = c[(k + 2) % 3] - c[k];
      least = std::min(least, std::atan2(Cross(u, v), Dot(u, v)));
    }
  }
  return least;
}

/// Neighbours know each other by the same side, of the same kind.
void ExpectMatching(const PlanMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const PlanTriangle& t = mesh.triangles()[i];
    EXPECT_GT(mesh.AreaOf(static_cast<int>(i)), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.neighbors[k] < 0) {
        EXPECT_TRUE(t.kinds[k] == SideKind::kJump ||
                    t.kinds[k] == SideKind::kOutline);
        continue;
      }
      const PlanTriangle& other = mesh.At(t.neighbors[k]);
      const auto back = static_cast<std::size_t>(
          std::ranges::find(other.neighbors, static_cast<int>(i)) -
          other.neighbors.begin());
      ASSERT_LT(back, 3U);
      EXPECT_EQ(other.corners[(back + 1) % 3], t.corners[(k + 2) % 3]);
      EXPECT_EQ(other.corners[(back + 2) % 3], t.corners[(k + 1) % 3]);
      EXPECT_EQ(other.kinds[back], t.kinds[k]);
      EXPECT_EQ(other.seams[back], t.seams[k]);
    }
  }
}

/// How long the sides of a kind are.
double LengthOf(const PlanMesh& mesh, SideKind kind) {
  double length = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const auto c = mesh.CornersOf(static_cast<int>(i));
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.triangles()[i].kinds[k] == kind)
        length += LengthOf(c[(k + 2) % 3] - c[(k + 1) % 3]);
    }
  }
  return length;
}

LitFloor BoxFloor() {
  std::vector<TestFace> faces = {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp}};
  AddBox(0.5, 1.75, 0.25, 1.5, 0, 1.5, faces);
  // A wall that ends on the floor.
  faces.push_back(
      {{{-2, -2, 0}, {-1, -1.5, 0}, {-1, -1.5, 1}, {-2, -2, 1}}, {}});
  return {3, faces};
}

TEST(PlanMesh, StaysAMeshWhenHalved) {
  const LitFloor floor = BoxFloor();
  PlanMesh mesh = floor.first().mesh;
  const double area = AreaOf(mesh);
  const double angle = LeastAngle(mesh);
  PortableRandom random(1);
  std::size_t told = 0;
  for (int i = 0; i < 400; ++i) {
    const int triangle =
        random.Integer(0, static_cast<int>(mesh.triangles().size()) - 1);
    const std::size_t before = mesh.triangles().size();
    const double longest = mesh.LongestSideOf(triangle);
    std::size_t added = 0;
    bool was_halved = false;
    mesh.Halve(triangle, [&](int old, int fresh) {
      ++added;
      EXPECT_EQ(static_cast<std::size_t>(fresh), mesh.triangles().size() - 1);
      was_halved = was_halved || old == triangle;
    });
    EXPECT_TRUE(was_halved);
    EXPECT_EQ(mesh.triangles().size(), before + added);
    EXPECT_LE(mesh.LongestSideOf(triangle), longest);
    told += added;
  }
  EXPECT_GT(told, 500U);
  ExpectMatching(mesh);
  EXPECT_NEAR(AreaOf(mesh), area, 1e-9);
  EXPECT_GE(LeastAngle(mesh), angle / 2 - 1e-9);
}

TEST(FirstMesh, SidesKnowTheirSeams) {
  const LitFloor floor = BoxFloor();
  const FirstMesh& first = floor.first();
  PlanMesh mesh = first.mesh;
  for (int i = 0; i < 100; ++i)
    mesh.Halve(7 * i % static_cast<int>(mesh.triangles().size()),
               [](int, int) {});
  std::vector<int> counts(first.seams.size());
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const PlanTriangle& triangle = mesh.triangles()[i];
    const auto corners = mesh.CornersOf(static_cast<int>(i));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(triangle.seams[k] >= 0, triangle.kinds[k] != SideKind::kInner);
      if (triangle.seams[k] < 0) continue;
      const auto name = static_cast<std::size_t>(triangle.seams[k]);
      const Seam& seam = first.seams[name];
      ++counts[name];
      EXPECT_EQ(seam.kind, triangle.kinds[k]);
      EXPECT_EQ(seam.line >= 0, seam.kind != SideKind::kOutline);
      const PlanPoint way = seam.to - seam.from;
      for (const std::size_t end : {(k + 1) % 3, (k + 2) % 3}) {
        const PlanPoint to = corners[end] - seam.from;
        EXPECT_LT(std::fabs(Cross(way, to)) / truelux::LengthOf(way),
                  8 * first.scale.margin);
        EXPECT_GT(Dot(way, to), -1e-9);
        EXPECT_LT(Dot(way, to), Dot(way, way) + 1e-9);
      }
    }
  }
  // An outline has a triangle at each part of it, others have two.
  for (std::size_t i = 0; i < counts.size(); ++i)
    EXPECT_GE(counts[i], first.seams[i].kind == SideKind::kOutline ? 1 : 2);
}

TEST(FirstMesh, CoversTheSurfaceAndHasItsLines) {
  const LitFloor floor = BoxFloor();
  const FirstMesh& first = floor.first();
  ExpectMatching(first.mesh);
  EXPECT_EQ(first.left_out, 0);
  EXPECT_NEAR(first.scale.size, 6, 1e-6);
  EXPECT_NEAR(AreaOf(first.mesh), 36, 1e-7);
  EXPECT_NEAR(LengthOf(first.mesh, SideKind::kOutline), 24, 1e-7);
  // Walls from both sides.
  EXPECT_NEAR(LengthOf(first.mesh, SideKind::kJump),
              2 * (4 * 1.25 + std::hypot(1, 0.5)), 1e-7);
  // The middle of each kink is on a side that knows it.
  std::size_t kinks = 0;
  for (const ExactSurfaceLine& line : floor.lines().lines) {
    // A kink along the outline has the surface on one side only.
    if (line.is_jump || (line.from.y == 3 && line.to.y == 3)) continue;
    ++kinks;
    const PlanPoint middle = {(line.from.x.get_d() + line.to.x.get_d()) / 2,
                              (line.from.y.get_d() + line.to.y.get_d()) / 2};
    bool is_there = false;
    for (std::size_t i = 0; i < first.mesh.triangles().size(); ++i) {
      const auto c = first.mesh.CornersOf(static_cast<int>(i));
      for (std::size_t k = 0; k < 3; ++k) {
        if (first.mesh.triangles()[i].kinds[k] != SideKind::kKink) continue;
        const PlanPoint way = c[(k + 2) % 3] - c[(k + 1) % 3];
        const PlanPoint from = middle - c[(k + 1) % 3];
        const double share = Dot(from, way) / Dot(way, way);
        is_there =
            is_there || (share >= 0 && share <= 1 &&
                         std::fabs(Cross(way, from)) < 1e-9 * LengthOf(way));
      }
    }
    EXPECT_TRUE(is_there) << middle.s << ", " << middle.t;
  }
  EXPECT_GT(kinks, 3U);
}

TEST(FirstMesh, KeepsAwayFromWallsByItsMargin) {
  const LitFloor floor = BoxFloor();
  const FirstMesh& first = floor.first();
  std::size_t beside = 0;
  for (const PlanPoint& p : first.mesh.points()) {
    // The box's outline, from outside and from inside.
    const double x = std::max(0.5 - p.s, p.s - 1.75);
    const double y = std::max(0.25 - p.t, p.t - 1.5);
    const double outside = std::max(x, y);
    if (std::fabs(outside) > 1e-6) continue;
    ++beside;
    EXPECT_GE(std::fabs(outside), 0.99 * first.scale.margin);
    EXPECT_LE(std::fabs(outside), 4.1 * first.scale.margin);
  }
  EXPECT_GE(beside, 8U);
}

TEST(FirstMesh, AWallWithoutKinksHasTwoSides) {
  // No lamp, so that no kink divides the trace of the wall.
  const LitFloor floor(
      2, {{{{0.7, -1, 0}, {0.7, 1, 0}, {0.7, 1, 0.5}, {0.7, -1, 0.5}}, {}}});
  ASSERT_EQ(floor.lines().lines.size(), 1U);
  PlanMesh mesh = floor.first().mesh;
  for (int i = 0; i < 2000; ++i)
    mesh.Halve(i % static_cast<int>(mesh.triangles().size()), [](int, int) {});
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    for (const int corner : mesh.triangles()[i].corners) {
      const Point3 at =
          floor.plan().PointAt(mesh.points()[static_cast<std::size_t>(corner)]);
      if (std::fabs(at.x - 0.7) > 1e-6 || std::fabs(at.y) > 0.9) continue;
      const double side =
          floor.plan().PointAt(mesh.CentreOf(static_cast<int>(i))).x - 0.7;
      EXPECT_GT((at.x - 0.7) * side, 0) << at.y;
      ++(side < 0 ? left : right);
    }
  }
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
}

TEST(FirstMesh, OfFacesThatAreNoRectangle) {
  // An L with a hole's worth of notch, as one face.
  const Ring ring = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0},
                     {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const LitFloor floor(
      MakeScene({{ring, {}}, {Ceiling(0, 1, 0, 1, 2), kUnitLamp}}));
  EXPECT_NEAR(AreaOf(floor.first().mesh), 6, 1e-8);
  EXPECT_NEAR(LengthOf(floor.first().mesh, SideKind::kOutline), 14, 1e-8);
  ExpectMatching(floor.first().mesh);
}

// Corners that are apart by less than a rounding are one place.
TEST(MoveInwards, ASideWithoutALengthHasNoDirection) {
  PlanTriangle triangle;
  triangle.corners = {0, 1, 2};
  triangle.neighbors = {-1, -1, -1};
  CutMesh mesh =
      CutApart(std::vector<PlanPoint>{{0, 0}, {1, 0}, {1, 0}}, {triangle});
  MoveInwards(1e-10, mesh);
  for (const PlanPoint& p : mesh.points)
    EXPECT_TRUE(std::isfinite(p.s) && std::isfinite(p.t));
}

}  // namespace
}  // namespace truelux
