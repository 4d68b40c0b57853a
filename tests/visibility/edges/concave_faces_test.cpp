// SPDX-License-Identifier: GPL-3.0-or-later
// Sources and blockers of many corners, concave and convex, which the contour
// engine cuts into convex pieces: the same bits from the engine without
// pieces, and from the same faces cut into triangles.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/scenes.h"
#include "support/shattered.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A star on an integer lattice, counter-clockwise seen from below, or a
/// regular polygon up to rounding.
std::vector<Point3> Star(PortableRandom& random, double x, double y, double z,
                         int size) {
  const int count = random.Integer(5, 20);
  const bool regular = random.OneIn(3);
  // Tilted by integers, so that it stays exactly planar.
  const int slope_x = random.Integer(-1, 1);
  const int slope_y = random.Integer(-1, 1);
  std::vector<Point3> ring;
  for (int k = 0; k < count; ++k) {
    const double turn = -2 * std::numbers::pi * (k + 0.3) / count;
    const double length = regular ? size : random.Integer((size + 3) / 4, size);
    const double dx = std::round(length * std::cos(turn));
    const double dy = std::round(length * std::sin(turn));
    ring.push_back({x + dx, y + dy, z + slope_x * dx + slope_y * dy});
  }
  return ring;
}

/// The scene, or nothing if rounding made a star meet itself.
std::vector<Scene> TryScene(const std::vector<TestFace>& faces) {
  SceneBuilder builder;
  for (const TestFace& face : faces)
    builder.AddFace(face.ring, face.emission);
  const Result<Scene> scene = builder.Build();
  return scene.ok() ? std::vector{*scene.value} : std::vector<Scene>{};
}

TEST(ConcaveFaces, AllEnginesAndTheTrianglesAgree) {
  int scenes = 0;
  int penumbra = 0;
  int dark = 0;
  int across_horizon = 0;
  for (std::uint64_t seed = 0; scenes < 80; ++seed) {
    ASSERT_LT(seed, 1000U);
    PortableRandom random(seed);
    std::vector<TestFace> faces{
        {Star(random, random.Integer(-4, 4), random.Integer(-4, 4),
              random.Integer(14, 20), 12),
         {3, 2, 1}}};
    for (int b = random.Integer(1, 4); b > 0; --b) {
      faces.push_back({Star(random, random.Integer(-4, 4),
                            random.Integer(-4, 4), random.Integer(4, 12), 5),
                       {}});
    }
    const std::vector<Scene> made = TryScene(faces);
    if (made.empty()) continue;
    ++scenes;
    const Scene& scene = made.front();
    const Scene shattered = Shattered(scene);
    const Oracle contour(scene);
    const Oracle arrangement(scene, {.engine = Engine::kArrangement});
    const Oracle triangles(shattered);
    const Oracle alone(*TryScene({faces.front()}).begin());
    for (int i = 0; i < 4; ++i) {
      const Receiver r{
          {1.0 * random.Integer(-6, 6), 1.0 * random.Integer(-6, 6), 0},
          // Steep enough for the horizon to cut the source now and then.
          {1.0 * random.Integer(-3, 3), 1.0 * random.Integer(-3, 3),
           1.0 * random.Integer(0, 2) + 0.125}};
      const Rgb value = contour.Evaluate(r).value;
      ASSERT_EQ(value, arrangement.Evaluate(r).value) << seed << ' ' << i;
      ASSERT_EQ(value, triangles.Evaluate(r).value) << seed << ' ' << i;
      const Rgb whole = alone.Evaluate(r).value;
      if (value[0] == 0) ++dark;
      if (value[0] > 0 && value[0] < whole[0]) ++penumbra;
      bool cut = false;
      for (const ContourArc& arc : alone.Contour(r).arcs)
        cut = cut || arc.edge_face == 0;
      if (cut) ++across_horizon;
    }
  }
  EXPECT_GT(penumbra, 60);
  EXPECT_GT(dark, 5);
  EXPECT_GT(across_horizon, 25);
}

/// Seen from the origin every edge of the blocker lies on a line between two
/// corners of the source, diagonals that its pieces share among them.
TEST(ConcaveFaces, BlockersAlongDiagonals) {
  const Ring comb{{-4, -4, 4}, {-4, 4, 4}, {-1, 4, 4}, {-1, 0, 4},
                  {1, 0, 4},   {1, 4, 4},  {4, 4, 4},  {4, -4, 4}};
  int partly_hidden = 0;
  const double whole = FromBelow({{comb, kLamp}})[0];
  for (std::size_t i = 0; i < comb.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Ring blocker = Scaled({comb[i], comb[j], comb[k]}, 0.5);
        const std::vector<TestFace> faces{{comb, kLamp}, {blocker, kBlack}};
        const std::vector<Scene> scene = TryScene(faces);
        ASSERT_FALSE(scene.empty());
        const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
        const Rgb value = Evaluate(scene[0], receiver);
        EXPECT_EQ(value, Evaluate(scene[0], receiver,
                                  {.engine = Engine::kArrangement}))
            << i << ' ' << j << ' ' << k;
        if (value[0] < whole) ++partly_hidden;
      }
    }
  }
  EXPECT_GT(partly_hidden, 40);
}

}  // namespace
}  // namespace truelux
