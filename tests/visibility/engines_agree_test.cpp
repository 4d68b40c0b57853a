// SPDX-License-Identifier: GPL-3.0-or-later
// The engines contour and arrangement, which share no line of visibility, and
// the sum over angular spans must give the same bits on random soups: lattices
// (everything coincides), the same with one-ulp noise (everything almost
// coincides), and general position.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "support/twin_values.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

enum class Kind { kLattice, kNoise, kGeneral };

int SceneCount() {
  return SweepSize(10, 60);
}

/// The scenes of which the oracle itself is asked for both twins.
constexpr int kAskedOfOracles = 2;

class EnginesAgree : public ::testing::TestWithParam<Kind> {};

TEST_P(EnginesAgree, OnRandomSoups) {
  const bool lattice = GetParam() != Kind::kGeneral;
  int lit = 0;
  int dark = 0;
  for (int seed = 0; seed < SceneCount(); ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) * 3 +
                          static_cast<std::uint64_t>(GetParam()));
    const int range = random.Integer(1, 4);
    std::vector<TestFace> faces =
        RandomScene(random, lattice, random.Integer(2, 16), range);
    if (GetParam() == Kind::kNoise) {
      for (TestFace& face : faces) {
        face.ring.resize(3);  // noise would bend a quad
        for (Point3& p : face.ring) {
          p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
        }
      }
    }
    const Scene scene = MakeScene(faces);
    const Oracle contour(scene);
    for (int i = 0; i < 4; ++i) {
      Receiver r = RandomReceiver(random, lattice, range);
      if (random.OneIn(4)) {
        r.on_face = random.Integer(1, static_cast<int>(faces.size()));
      }
      const Rgb value = contour.Evaluate(r).value;
      const TwinValues twins = TwinValuesOf(scene, r);
      ASSERT_EQ(value, twins.arrangement)
          << "seed " << seed << ", receiver " << i;
      ASSERT_EQ(value, twins.spans) << "seed " << seed << ", receiver " << i;
      if (seed < kAskedOfOracles) {
        for (const Engine engine :
             {Engine::kArrangement, Engine::kAngularSpans}) {
          ASSERT_EQ(value, Oracle(scene, {.engine = engine}).Evaluate(r).value)
              << "seed " << seed << ", receiver " << i;
        }
      }
      ++(value[0] > 0 ? lit : dark);
    }
  }
  EXPECT_GT(lit, SceneCount() / 2);
  EXPECT_GT(dark, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EnginesAgree,
                         ::testing::Values(Kind::kLattice, Kind::kNoise,
                                           Kind::kGeneral));

}  // namespace
}  // namespace truelux
