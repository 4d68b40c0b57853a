// SPDX-License-Identifier: GPL-3.0-or-later
// The contour engine leaves out and cuts short what cannot matter; its slow
// twin does not. Both must give the same bits, on soups in general position,
// on lattices (everything coincides), and on lattices one ulp off.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/evaluate.h"
#include "support/plain_contour.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

enum class Kind { kLattice, kNoise, kGeneral };

/// Soups one ulp off a lattice are slow: the exact stage decides much.
int SceneCount(Kind kind) {
  const int count = kind == Kind::kNoise ? 60 : 800;
  return SweepSize(count, count);
}

/// A soup, now and then with many faces, so that pruning has work to do.
Scene RandomSoup(Kind kind, PortableRandom& random, int range) {
  const int faces =
      random.OneIn(50) ? random.Integer(40, 60) : random.Integer(2, 24);
  std::vector<TestFace> soup =
      RandomScene(random, kind != Kind::kGeneral, faces, range);
  if (kind == Kind::kNoise) {
    for (TestFace& face : soup) {
      face.ring.resize(3);  // noise would bend a quad
      for (Point3& p : face.ring) {
        p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
      }
    }
  }
  return MakeScene(soup);
}

class Pruning : public ::testing::TestWithParam<Kind> {};

TEST_P(Pruning, ChangesNoBit) {
  const Kind kind = GetParam();
  const bool lattice = kind != Kind::kGeneral;
  int lit = 0;
  int dark = 0;
  std::uint64_t plain_arcs = 0;
  std::uint64_t pruned_arcs = 0;
  for (int seed = 0; seed < SceneCount(kind); ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) * 3 +
                          static_cast<std::uint64_t>(kind) + 1000);
    const int range = random.Integer(1, 4);
    const Scene scene = RandomSoup(kind, random, range);
    const Oracle oracle(scene);
    for (int i = 0; i < 3; ++i) {
      Receiver r = RandomReceiver(random, lattice, range);
      if (random.OneIn(6)) {
        r.on_face = random.Integer(1, static_cast<int>(scene.faces().size()));
      }
      const ContourQuery query{scene, r};
      const Contour plain = PlainContour(query);
      const Irradiance expected = EvaluateContour(query, plain, {});
      const Irradiance actual = oracle.Evaluate(r);
      ASSERT_EQ(actual.value, expected.value)
          << "seed " << seed << ", receiver " << i;
      ++(actual.value[0] > 0 ? lit : dark);
      plain_arcs += plain.arcs.size();
      pruned_arcs += actual.statistics.arcs;
    }
  }
  EXPECT_GT(lit, SceneCount(kind) / 2);
  EXPECT_GT(dark, SceneCount(kind) / 10);
  // The twin splits arcs at diagonals and counts each triangle of a face.
  EXPECT_GE(plain_arcs, pruned_arcs);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Pruning,
                         ::testing::Values(Kind::kLattice, Kind::kNoise,
                                           Kind::kGeneral));

}  // namespace
}  // namespace truelux
