// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement divides what it is told, and sides remember which edge they are of.

#include "isomesh/refined_plane.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "isomesh/plan_checks.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A square with a square hole beside a jump that stands alone, a kink and a
/// contour.
EdgePlan HoledPlan() {
  std::vector<Seam> seams = RectangleSeams({0, 0}, {4, 4}, SideKind::kOutline);
  for (const Seam& seam : RectangleSeams({1, 1}, {2, 2}, SideKind::kOutline))
    seams.push_back(seam);
  seams.push_back({{3, 1}, {3, 3}, SideKind::kJump, 0});
  seams.push_back({{0, 4}, {1, 2}, SideKind::kKink, 1});
  return EdgePlanOf(seams,
                    std::vector<ContourLine>{ArcLine(0, {2.2, 3.2}, 0.5, 40)},
                    {1e-3, 1e-5});
}

bool IsInHoledPlan(const PlanPoint& p) {
  return p.s > 0 && p.s < 4 && p.t > 0 && p.t < 4 &&
         !(p.s > 1 && p.s < 2 && p.t > 1 && p.t < 2);
}

double AreaOf(const SharedMesh& mesh, const PlanTriangle& triangle) {
  const auto at = [&](std::size_t k) {
    return mesh.points[static_cast<std::size_t>(triangle.corners[k])];
  };
  return 0.5 * Cross(at(1) - at(0), at(2) - at(0));
}

double SideOf(const SharedMesh& mesh, const PlanTriangle& triangle,
              std::size_t k) {
  const auto at = [&](std::size_t corner) {
    return mesh.points[static_cast<std::size_t>(triangle.corners[corner % 3])];
  };
  return truelux::LengthOf(at(k + 1) - at(k + 2));
}

/// Areas fill the plan, neighbours match, and sides of an edge have its length.
void ExpectWellMade(const EdgePlan& plan, const SharedMesh& mesh) {
  double area = 0;
  std::vector<double> lengths(plan.edges.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const PlanTriangle& triangle = mesh.triangles[i];
    EXPECT_GT(AreaOf(mesh, triangle), 0);
    area += AreaOf(mesh, triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const int next = triangle.neighbors[k];
      const bool is_cut = triangle.kinds[k] == SideKind::kJump ||
                          triangle.kinds[k] == SideKind::kOutline;
      EXPECT_EQ(next < 0, is_cut);
      if (next >= 0) {
        const auto& back =
            mesh.triangles[static_cast<std::size_t>(next)].neighbors;
        EXPECT_EQ(std::ranges::count(back, static_cast<int>(i)), 1);
      }
      if (triangle.seams[k] < 0) continue;
      const auto edge = static_cast<std::size_t>(triangle.seams[k]);
      EXPECT_EQ(plan.edges[edge].kind, triangle.kinds[k]);
      // Outlines have one triangle, other edges two.
      lengths[edge] += SideOf(mesh, triangle, k) *
                       (plan.edges[edge].kind == SideKind::kOutline ? 1 : 0.5);
    }
  }
  EXPECT_NEAR(area, 15, 1e-12);
  for (std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], LengthOf(plan, plan.edges[i]), 1e-12);
}

TEST(RefinedPlane, IsTheSurfaceWithAllEdges) {
  const EdgePlan plan = HoledPlan();
  const RefinedPlane plane(plan, IsInHoledPlan);
  ExpectWellMade(plan, plane.Mesh());
  EXPECT_EQ(plane.point_count(), plan.points.size());
}

TEST(RefinedPlane, DividesWhatIsListedAndKeepsTheEdges) {
  const EdgePlan plan = HoledPlan();
  RefinedPlane plane(plan, IsInHoledPlan);
  for (int round = 0; round < 6; ++round) {
    const SharedMesh mesh = plane.Mesh();
    std::map<Corners, double> listed;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 7)
      listed[OrderedCorners(mesh.triangles[i].corners)] =
          1 + static_cast<double>(i % 3);
    const std::size_t before = plane.point_count();
    plane.Divide(listed, 1'000'000, nullptr);
    EXPECT_GT(plane.point_count(), before);
    const SharedMesh after = plane.Mesh();
    ExpectWellMade(plan, after);
    for (const PlanTriangle& triangle : after.triangles)
      EXPECT_FALSE(listed.contains(OrderedCorners(triangle.corners)));
    // Points keep their numbers.
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      EXPECT_EQ(after.points[i], mesh.points[i]);
  }
}

TEST(RefinedPlane, EndsAtSoManyPointsAndWhenItIsStopped) {
  const EdgePlan plan = HoledPlan();
  RefinedPlane plane(plan, IsInHoledPlan);
  std::map<Corners, double> all;
  for (const PlanTriangle& triangle : plane.Mesh().triangles)
    all[OrderedCorners(triangle.corners)] = 1;
  const std::size_t before = plane.point_count();
  plane.Divide(all, before + 5, nullptr);
  EXPECT_EQ(plane.point_count(), before + 5);
  ExpectWellMade(plan, plane.Mesh());
  const StopFlag stop = true;
  EXPECT_THROW(plane.DivideTo(0.01, &stop), Stopped);
}

TEST(RefinedPlane, DividesToALength) {
  const EdgePlan plan = HoledPlan();
  RefinedPlane plane(plan, IsInHoledPlan);
  plane.DivideTo(0.2, nullptr);
  const SharedMesh mesh = plane.Mesh();
  ExpectWellMade(plan, mesh);
  double longest = 0;
  for (const PlanTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, SideOf(mesh, triangle, k));
  }
  EXPECT_LE(longest, 0.2);
  EXPECT_GT(longest, 0.1);
}

TEST(RefinedPlane, FindsTheTriangleOfAPoint) {
  const EdgePlan plan = HoledPlan();
  RefinedPlane plane(plan, IsInHoledPlan);
  plane.DivideTo(0.5, nullptr);
  const SharedMesh mesh = plane.Mesh();
  PortableRandom random(5);
  int found = 0;
  int missed = 0;
  for (int i = 0; i < 500; ++i) {
    const PlanPoint p = {random.Uniform(-1, 5), random.Uniform(-1, 5)};
    const auto index = plane.TriangleAt(p);
    ASSERT_EQ(index.has_value(), IsInHoledPlan(p)) << p.s << ' ' << p.t;
    if (!index) {
      ++missed;
      continue;
    }
    ++found;
    const PlanTriangle& triangle =
        mesh.triangles[static_cast<std::size_t>(*index)];
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanPoint a =
          mesh.points[static_cast<std::size_t>(triangle.corners[k])];
      const PlanPoint b =
          mesh.points[static_cast<std::size_t>(triangle.corners[(k + 1) % 3])];
      EXPECT_GE(Cross(b - a, p - a), 0);
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(missed, 100);
}

}  // namespace
}  // namespace truelux
