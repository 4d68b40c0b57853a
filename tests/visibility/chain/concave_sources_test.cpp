// SPDX-License-Identifier: GPL-3.0-or-later
// Chains before sources of many convex parts, which an edge may leave and enter
// again. On a lattice, where edges end on the source's boundary, cross it at its
// corners, and run along its diagonals.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/evaluate.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/shattered.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// Columns side by side on a common line or on two sides of it, at z = 4, of
/// even coordinates; emits downwards.
Ring Columns(PortableRandom& random) {
  const int count = random.Integer(2, 6);
  const double left = -2.0 * random.Integer(0, count);
  const bool both_sides = random.OneIn(2);
  Ring up;    // from left to right
  Ring down;  // likewise
  int height = 0;
  int depth = 0;
  for (int i = 0; i < count; ++i) {
    // No two columns side by side end at one height.
    height = (height + random.Integer(1, 3)) % 4;
    depth = both_sides ? (depth + random.Integer(1, 2)) % 3 : 0;
    const double x = left + 2 * i;
    for (const double at : {x, x + 2}) {
      up.push_back({at, 2.0 + 2 * height, 4});
      if (both_sides || at == left || i == count - 1)
        down.push_back({at, -2.0 * depth, 4});
    }
  }
  if (!both_sides) down = {down.front(), down.back()};
  // Clockwise from above.
  Ring ring = up;
  ring.insert(ring.end(), down.rbegin(), down.rend());
  return ring;
}

/// Doubled, a corner at z = 2 lies on the lattice of the source.
Point3 Corner(PortableRandom& random) {
  return {1.0 * random.Integer(-4, 4), 1.0 * random.Integer(-2, 4),
          random.OneIn(4) ? 1.0 * random.Integer(1, 5) : 2.0};
}

void AddTriangle(const Point3& a, const Point3& b, const Point3& c,
                 std::vector<TestFace>& faces) {
  if (!OnOneLine(a, b, c)) faces.push_back({{a, b, c}, kBlack});
}

/// A strip or a fan of triangles that may overlap.
void AddStrip(PortableRandom& random, std::vector<TestFace>& faces) {
  const bool is_fan = random.OneIn(2);
  const int count = random.Integer(1, 5);
  Point3 a = Corner(random);
  Point3 b = Corner(random);
  for (int i = 0; i < count; ++i) {
    const Point3 c = Corner(random);
    if (i % 2 == 0) {
      AddTriangle(a, b, c, faces);
    } else {
      AddTriangle(b, a, c, faces);
    }
    if (!is_fan) a = b;
    b = c;
  }
}

TEST(ConcaveSources, BothPathsAgree) {
  const int count = SweepSize(1500, 20000);
  int shaded = 0;
  ChainCounts counts;
  for (int seed = 0; seed < count; ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) + 1);
    std::vector<TestFace> faces{{Columns(random), kLamp}};
    const int strips = random.Integer(1, 4);
    for (int i = 0; i < strips; ++i)
      AddStrip(random, faces);
    const Scene scene = MakeScene(faces);
    const ContourEngine by_blockers(scene, ContourPath::kBlockers);
    const ContourEngine by_chain(scene, ContourPath::kCheckedChain);
    // Its sources are single cones, without an outline.
    const Scene shattered = Shattered(scene);
    const ContourEngine by_triangles(shattered, ContourPath::kBlockers);
    ContourBuilder blockers_path(by_blockers);
    ContourBuilder chain_path(by_chain);
    ContourBuilder triangles_path(by_triangles);
    for (int i = 0; i < 4; ++i) {
      const Receiver r{
          {2.0 * random.Integer(-1, 1), 2.0 * random.Integer(-1, 1),
           1.0 * -random.Integer(0, 1)},
          {0, 0.5 * random.Integer(-1, 1), 1},
          0};
      const ContourQuery query{scene, r};
      Contour contour;
      blockers_path.Build(query, contour);
      const Rgb by_outline = EvaluateContour(query, contour, {}).value;
      const ContourQuery in_triangles{shattered, r};
      triangles_path.Build(in_triangles, contour);
      const Rgb expected = EvaluateContour(in_triangles, contour, {}).value;
      ASSERT_EQ(by_outline, expected) << "seed " << seed << ", receiver " << i;
      chain_path.Build(query, contour);
      const Rgb actual = EvaluateContour(query, contour, {}).value;
      ASSERT_EQ(actual, expected) << "seed " << seed << ", receiver " << i;
      if (actual[0] > 0 && contour.arcs.size() > faces[0].ring.size()) ++shaded;
    }
    counts.diagonals += chain_path.chain_counts().diagonals;
    counts.touching += chain_path.chain_counts().touching;
    counts.entered += chain_path.chain_counts().entered;
    counts.propagated += chain_path.chain_counts().propagated;
  }
  EXPECT_GT(shaded, count);
  EXPECT_GT(counts.diagonals, 100U);
  EXPECT_GT(counts.touching, 1000U);
  EXPECT_GT(counts.entered, 1000U);
  EXPECT_GT(counts.propagated, 1000U);
}

}  // namespace
}  // namespace truelux
