// SPDX-License-Identifier: GPL-3.0-or-later
// No gradient in a triangle differs from that at its centre by more than the
// bound, whatever stands before the lamps; and the bound is not idle.

#include "isolux/gradient_change.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "isolux/lit_floor.h"
#include "isolux/sight.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

struct Tally {
  int triangles = 0;  ///< with a finite bound
  int unbounded = 0;
  int points = 0;
  int with_jump = 0;  ///< triangles with seen ends of edges
  int without_edges = 0;
  double closest = 0;  ///< the largest change by its bound
};

/// Compares at random points of the triangles of a refined mesh.
void CheckFloor(const LitFloor& floor, double longest, PortableRandom& random,
                Tally& tally) {
  MeshSearch search = floor.Search();
  search.RefineTo(longest);
  const PlanMesh& mesh = search.mesh();
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    if (!random.OneIn(8)) continue;
    const auto triangle = static_cast<int>(i);
    const auto corners = mesh.CornersOf(triangle);
    const PlanPoint centre = mesh.CentreOf(triangle);
    const Sight sight =
        Narrowed(floor.features(), WholeSight(floor.features()), corners);
    const GradientChange change =
        GradientChangeOver(floor.features(), sight, corners, centre, HUGE_VAL);
    if (!std::isfinite(change.rate + change.jump)) {
      ++tally.unbounded;
      continue;
    }
    const LightSample at_centre = floor.probe().SampleAt(centre);
    if (!at_centre.is_defined) continue;
    ++tally.triangles;
    if (change.jump > 0) ++tally.with_jump;
    if (std::ranges::all_of(sight, [](const LampSight& lamp) {
          return lamp.blockers.empty();
        })) {
      ++tally.without_edges;
    }
    for (int k = 0; k < 4; ++k) {
      double a = random.Unit();
      double b = random.Unit();
      if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      const PlanPoint p = corners[0] + a * (corners[1] - corners[0]) +
                          b * (corners[2] - corners[0]);
      const LightSample sample = floor.probe().SampleAt(p);
      if (!sample.is_defined) continue;
      ++tally.points;
      const double found = LengthOf(sample.gradient - at_centre.gradient);
      const double bound = change.Over(LengthOf(p - centre));
      const double rounding =
          sample.gradient_bound + at_centre.gradient_bound + 1e-12;
      ASSERT_LE(found, bound + rounding)
          << "at " << p.s << ", " << p.t << " from " << centre.s << ", "
          << centre.t;
      if (bound > 0) tally.closest = std::max(tally.closest, found / bound);
    }
  }
}

TEST(GradientChange, HoldsUnderOneLamp) {
  PortableRandom random(1);
  Tally tally;
  CheckFloor({4, {{Ceiling(-1, 1, -1, 1, 2), kUnitLamp}}}, 0.4, random, tally);
  EXPECT_GT(tally.points, 300);
  EXPECT_EQ(tally.unbounded, 0);
  EXPECT_EQ(tally.with_jump, 0);
  // It is a bound on what happens, not on everything.
  EXPECT_GT(tally.closest, 0.1);
}

TEST(GradientChange, HoldsBehindABox) {
  PortableRandom random(2);
  std::vector<TestFace> faces = {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp}};
  AddBox(0.5, 1.75, 0.25, 1.5, 0, 1.5, faces);
  Tally tally;
  CheckFloor({4, faces}, 0.25, random, tally);
  EXPECT_GT(tally.points, 1000);
  EXPECT_GT(tally.with_jump, 100);
  EXPECT_GT(tally.without_edges, 100);
  EXPECT_GT(tally.unbounded, 0);  // at the feet of the box
  EXPECT_GT(tally.closest, 0.2);
}

TEST(GradientChange, HoldsUnderALampThatStandsOnAWall) {
  // Its plane goes through the floor: the surface is near it, and beyond.
  PortableRandom random(3);
  std::vector<TestFace> faces = {
      {{{0, 0.125, 1}, {0, 1.5, 1}, {0.5, 1.5, 2}, {0.5, 0.125, 2}}, kUnitLamp},
      {{{-1, 0, 0.5}, {-0.5, 1, 0.5}, {-0.5, 1.25, 1.5}}, {}},
      {{{1, 0, 0.5}, {0.5, 1, 0.5}, {0.5, 1.25, 1.5}}, {}}};
  for (const bool is_reversed : {false, true}) {
    if (is_reversed) faces[0].ring = Reversed(faces[0].ring);
    Tally tally;
    CheckFloor({4, faces}, 0.25, random, tally);
    EXPECT_GT(tally.points, 500);
    EXPECT_GT(tally.with_jump, 10);
    EXPECT_GT(tally.closest, 0.05);
  }
}

TEST(GradientChange, HoldsUnderALongEdge) {
  // Nearly all of the change is that of the edge, close over the floor, whose
  // ends are far away.
  PortableRandom random(5);
  Tally tally;
  CheckFloor({1,
              {{Ceiling(-20, 20, -20, 20, 8), kUnitLamp},
               {Ceiling(-20, 20, -20, 0, 0.25), {}}}},
             0.03, random, tally);
  EXPECT_GT(tally.points, 1000);
  EXPECT_GT(tally.closest, 0.1);
}

TEST(GradientChange, HoldsUnderCrossingEdges) {
  // The seen parts of both edges end where they seem to cross.
  PortableRandom random(6);
  for (const double height : {0.5, 1.75}) {
    Tally tally;
    CheckFloor({1,
                {{Ceiling(-20, 20, -20, 20, 8), kUnitLamp},
                 {Ceiling(-20, 20, -20, 0, height), {}},
                 {Ceiling(-20, 0, -20, 20, 1), {}}}},
               0.03, random, tally);
    EXPECT_GT(tally.points, 1000);
    EXPECT_GT(tally.with_jump, 1000);
    EXPECT_GT(tally.closest, 0.1);
  }
}

TEST(GradientChange, HoldsInRandomScenes) {
  PortableRandom random(4);
  Tally tally;
  const int count = SweepSize(12, 300);
  for (int i = 0; i < count; ++i) {
    std::vector<TestFace> faces;
    const bool lattice = random.OneIn(2);
    for (TestFace& face : RandomScene(random, lattice, 6, 3)) {
      for (Point3& p : face.ring)
        p.z = random.OneIn(3) ? p.z : p.z + 3.5;
      if (OnOneLine(face.ring[0], face.ring[1], face.ring[2])) continue;
      face.ring.resize(3);
      faces.push_back(face);
    }
    faces.push_back({Ceiling(-1, 1, -1, 1, 7), {2, 2, 2}});
    CheckFloor({4, faces}, 0.5, random, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.points, 100 * count);
  EXPECT_GT(tally.with_jump, 10 * count);
  EXPECT_GT(tally.closest, 0.2);
}

}  // namespace
}  // namespace truelux
