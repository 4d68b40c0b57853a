// SPDX-License-Identifier: GPL-3.0-or-later
// The whole view's slow twin: along a random direction, the region that holds
// it shows the face that exact ray casting meets first.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"
#include "support/random_scene.h"
#include "support/view_sums.h"
#include "visibility/view/whole_view.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// The number of the face that is seen along d, 0 for none; nothing if d meets
/// an edge.
std::optional<int> FaceAlong(const ContourQuery& query, const Vec3<Exact>& d) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  int front = 0;
  Exact front_height;
  Exact front_slope;
  const auto triangles = TrianglesOf(query.scene);
  for (const TriangleId t : triangles.ids()) {
    Exact height = exact.Height(t);
    if (height.is_zero()) continue;
    bool inside = true;
    const auto corners = CornersOf(triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign side =
          SignOf(Determinant(exact.FromReceiver(corners[k]),
                             exact.FromReceiver(corners[(k + 1) % 3]), d)) *
          SignOf(height);
      if (side == Sign::kZero) return std::nullopt;
      inside = inside && side == Sign::kPositive;
    }
    if (!inside) continue;
    Exact slope = Dot(exact.TriangleNormal(t), d);
    if (SignOf(height) == Sign::kNegative) {
      height = -height;
      slope = -slope;
    }
    // Triangles come in file order: of equals the first stays.
    if (front == 0 || SignOf(slope * front_height - front_slope * height) ==
                          Sign::kPositive) {
      front = NumberOf(FaceOf(query.scene, FacetOf(triangles[t]))).value();
      front_height = height;
      front_slope = slope;
    }
  }
  return front;
}

/// How often the border of a region goes around d: the arcs of it that the way
/// from d straight down to the horizon crosses, each with its sense.
int WindingAround(const WholeView& view, int region, const Vector3& d,
                  const Vector3& down) {
  const Vector3 way = CrossOf(d, down);
  int winding = 0;
  for (const WholeViewArc& arc : view.arcs) {
    if (arc.kind == ViewArcKind::kHorizon) continue;
    if (arc.left != region && arc.right != region) continue;
    const Vector3& from = DirectionOf(view, arc.from);
    const Vector3& to = DirectionOf(view, arc.to);
    const double side_from = DotOf(way, from);
    const double side_to = DotOf(way, to);
    if ((side_from >= 0) == (side_to >= 0)) continue;
    // Where the arc crosses the plane of the way.
    const double s = side_from / (side_from - side_to);
    const Vector3 at{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y),
                     from.z + s * (to.z - from.z)};
    if (DotOf(CrossOf(d, at), way) < 0) continue;
    const bool region_left = arc.left == region;
    winding += (side_from < side_to) == region_left ? 1 : -1;
  }
  // What lies at the end of the way, just above the horizon, counts from there.
  for (const WholeViewArc& arc : view.arcs) {
    if (arc.kind != ViewArcKind::kHorizon || arc.left != region) continue;
    if (arc.from == arc.to) return winding + 1;
    const Vector3& from = DirectionOf(view, arc.from);
    const Vector3& n = arc.plane_normal;
    const auto turn = [&](const Vector3& v) {
      const double angle =
          std::atan2(DotOf(CrossOf(from, v), n) / LengthOf(n), DotOf(from, v));
      return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    };
    if (turn(down) < AngleOf(view, arc)) return winding + 1;
  }
  return winding;
}

TEST(WholeViewRays, EveryDirectionIsInTheRegionOfTheFaceThatARayMeets) {
  PortableRandom random(31);
  int rays = 0;
  int faces_hit = 0;
  for (int i = 0; i < 60; ++i) {
    const bool lattice = i % 2 == 0;
    const ContourQuery query{
        MakeScene(RandomScene(random, lattice, random.Integer(1, 10))),
        RandomReceiver(random, lattice)};
    const WholeView view = WholeViewOf(query);
    const Vector3& n = query.receiver.normal;
    for (int k = 0; k < 40; ++k) {
      Vector3 d{random.Uniform(-1, 1), random.Uniform(-1, 1),
                random.Uniform(-1, 1)};
      if (DotOf(d, n) < 0) d = Negated(d);
      // Down to the horizon, away from the normal.
      const double rise = DotOf(d, n) / DotOf(n, n);
      const Vector3 down{d.x - rise * n.x, d.y - rise * n.y, d.z - rise * n.z};
      const auto face = FaceAlong(query, {d.x, d.y, d.z});
      if (!face || rise < 1e-6) continue;
      int holding = 0;
      for (std::size_t r = 0; r < view.regions.size(); ++r) {
        const int winding = WindingAround(view, static_cast<int>(r), d, down);
        EXPECT_TRUE(winding == 0 || winding == 1) << winding;
        if (winding == 0) continue;
        ++holding;
        EXPECT_EQ(view.regions[r].face, *face) << "scene " << i;
      }
      EXPECT_EQ(holding, 1);
      ++rays;
      faces_hit += *face > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(rays, 2000);
  EXPECT_GT(faces_hit, 400);
}

}  // namespace
}  // namespace truelux
