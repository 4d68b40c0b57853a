// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices have the light of their side of a jump, and at its end that of their
// direction.

#include "isomesh/light_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "isolux/lit_floor.h"
#include "isomesh/edge_plan.h"
#include "isomesh/refined_plane.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A lamp beside a wall that stands on the floor from (0, -1) to (0, 1).
LitFloor WallFloor() {
  std::vector<TestFace> faces = {
      {{{1, -1, 2}, {1, 1, 2}, {2, 1, 2}, {2, -1, 2}}, kUnitLamp},
      {{{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}}, {}}};
  return {3, faces};
}

class LightOfAWall : public ::testing::Test {
 protected:
  [[nodiscard]] LightMesh Light(double tolerance) {
    const EdgePlan plan = EdgePlanOf(floor_.first().seams, {}, {1e-3, 1e-5});
    RefinedPlane plane(plan, [](const PlanPoint&) { return true; });
    plane.DivideTo(0.3, nullptr);
    shared_ = plane.Mesh();
    return LightMeshOf(floor_.probe(), shared_, floor_.first().scale.margin,
                       tolerance, known_, 2, {});
  }

  [[nodiscard]] static PlanPoint At(const LightMesh& mesh, int vertex) {
    return mesh.vertices[static_cast<std::size_t>(vertex)].at;
  }

  LitFloor floor_ = WallFloor();
  SharedMesh shared_;
  KnownValues known_;
};

TEST_F(LightOfAWall, ValuesAreTheOraclesBesideTheJump) {
  const LightMesh mesh = Light(1e-3);
  std::map<std::pair<double, double>, std::vector<double>> by_place;
  for (const LightVertex& vertex : mesh.vertices) {
    EXPECT_EQ(vertex.value, floor_.probe().ValueAt(vertex.receiver).value);
    EXPECT_EQ(vertex.at,
              shared_.points[static_cast<std::size_t>(vertex.origin)]);
    EXPECT_LT(LengthOf(vertex.at - vertex.receiver), 1e-8);
    by_place[{vertex.at.s, vertex.at.t}].push_back(vertex.value);
  }
  // In the plan's frame the wall is a segment between two points of its kind.
  int doubled = 0;
  for (const PlanTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.kinds[k] != SideKind::kJump) continue;
      const PlanPoint p = At(mesh, triangle.corners[(k + 1) % 3]);
      const auto& values = by_place.at({p.s, p.t});
      EXPECT_GE(values.size(), 2U);
      const auto [least, most] = std::ranges::minmax(values);
      // Behind the wall only some of the lamp is seen.
      if (values.size() == 2) {
        EXPECT_GT(most - least, 0.01);
      }
      ++doubled;
    }
  }
  EXPECT_GT(doubled, 10);
}

TEST_F(LightOfAWall, AtTheEndOfTheWallEachTriangleHasItsOwnValue) {
  const LightMesh divided = Light(1e-3);
  const LightMesh whole = Light(1);
  EXPECT_EQ(divided.triangles.size(), whole.triangles.size());
  // The ends of the wall, in the plan.
  const Vec3<double> end = floor_.plan().PlaceOf({0, 1, 0});
  const auto at_end = [&](const LightMesh& mesh) {
    return std::ranges::count_if(mesh.vertices, [&](const LightVertex& v) {
      return v.at == PlanPoint{end.x, end.y};
    });
  };
  EXPECT_EQ(at_end(whole), 1);
  std::ptrdiff_t triangles = 0;
  for (const PlanTriangle& triangle : divided.triangles) {
    triangles += std::ranges::count_if(triangle.corners, [&](int corner) {
      return At(divided, corner) == PlanPoint{end.x, end.y};
    });
  }
  EXPECT_GE(triangles, 4);
  EXPECT_EQ(at_end(divided), triangles);
  // In each of them E near the end is as the vertex has it.
  for (const PlanTriangle& triangle : divided.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (At(divided, triangle.corners[k]) != PlanPoint{end.x, end.y}) continue;
      const PlanPoint at = At(divided, triangle.corners[k]);
      const PlanPoint p = At(divided, triangle.corners[(k + 1) % 3]) - at;
      const PlanPoint q = At(divided, triangle.corners[(k + 2) % 3]) - at;
      const PlanPoint near =
          at + 1e-6 * ((1 / LengthOf(p)) * p + (1 / LengthOf(q)) * q);
      EXPECT_NEAR(
          divided.vertices[static_cast<std::size_t>(triangle.corners[k])].value,
          floor_.probe().ValueAt(near).value, 1e-5);
    }
  }
}

TEST_F(LightOfAWall, AsksOnce) {
  (void)Light(1e-3);
  const std::uint64_t count = floor_.probe().count();
  EXPECT_GT(count, 300U);
  (void)Light(1e-3);
  EXPECT_EQ(floor_.probe().count(), count);
}

}  // namespace
}  // namespace truelux
