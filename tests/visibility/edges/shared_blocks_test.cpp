// SPDX-License-Identifier: GPL-3.0-or-later
// Many receivers in one call, one by one, and in another order: the same bits.
// And what a receiver costs depends on what lies between it and the sources,
// not on the size of the scene.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// Near each other, far apart, with one normal or many.
std::vector<Receiver> RandomReceivers(PortableRandom& random, bool lattice) {
  std::vector<Receiver> receivers;
  const bool near = random.OneIn(2);
  const bool one_normal = random.OneIn(2);
  const Receiver first = RandomReceiver(random, lattice);
  const int count = random.Integer(1, 40);
  for (int i = 0; i < count; ++i) {
    Receiver r = RandomReceiver(random, lattice);
    if (near) {
      r.position = {first.position.x + 0.01 * i, first.position.y,
                    first.position.z};
    }
    if (one_normal) r.normal = first.normal;
    if (random.OneIn(8)) r.on_face = random.Integer(1, 5);
    receivers.push_back(r);
  }
  return receivers;
}

TEST(SharedBlocks, GroupingChangesNoBit) {
  PortableRandom random(1);
  int lit = 0;
  for (int i = 0; i < 150; ++i) {
    const bool lattice = i % 2 == 0;
    const Scene scene =
        MakeScene(RandomScene(random, lattice, random.Integer(5, 60)));
    const Oracle oracle(scene);
    const std::vector<Receiver> receivers = RandomReceivers(random, lattice);
    const std::vector<Receiver> backwards(receivers.rbegin(), receivers.rend());
    const auto together = oracle.Evaluate(receivers);
    const auto reversed = oracle.Evaluate(backwards);
    ASSERT_EQ(together.size(), receivers.size());
    for (std::size_t k = 0; k < receivers.size(); ++k) {
      const Irradiance alone = oracle.Evaluate(receivers[k]);
      EXPECT_EQ(together[k].value, alone.value);
      EXPECT_EQ(together[k].bound, alone.bound);
      EXPECT_EQ(reversed[receivers.size() - 1 - k].value, alone.value);
      if (alone.value[0] > 0) ++lit;
    }
  }
  EXPECT_GT(lit, 300);
}

TEST(SharedBlocks, AnOracleIsAsGoodAfterAnException) {
  const Scene scene = MakeScene({{Ceiling(-1, 1, -1, 1, 2), kLamp}});
  const Oracle oracle(scene);
  const std::vector<Receiver> receivers(20, Receiver{{0, 0, 0}, {0, 0, 1}, 0});
  const Rgb expected = oracle.Evaluate(receivers[0]).value;
  int taken = 0;
  EXPECT_THROW(oracle.Evaluate(receivers,
                               [&taken](std::size_t, const Irradiance&) {
                                 if (++taken == 5) throw 7;
                               }),
               int);
  EXPECT_EQ(taken, 5);
  // Far from the block that was left.
  EXPECT_EQ(oracle.Contour({{9, 9, 0}, {-1, -1, 1}, 0}).arcs.size(), 4U);
  EXPECT_EQ(oracle.Evaluate(receivers[0]).value, expected);
}

/// A lamp, 24 triangles below it, and `count` more that spread outwards.
Scene Outward(int count) {
  PortableRandom random(3);
  std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp}};
  const auto add = [&](double x, double y) {
    const auto corner = [&]() -> Point3 {
      return {x + random.Uniform(-0.4, 0.4), y + random.Uniform(-0.4, 0.4),
              2 + random.Uniform(-0.4, 0.4)};
    };
    faces.push_back({{corner(), corner(), corner()}, kBlack});
  };
  for (int i = 0; i < 24; ++i)
    add(random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6));
  for (int i = 0; i < count; ++i) {
    const int row = i / 100;
    add(8 + 2.0 * (i % 100), 8 + 2.0 * row);
  }
  return MakeScene(faces);
}

TEST(SharedBlocks, WhatIsFarAwayCostsNothing) {
  const Receiver receiver{{0.1, 0.05, 0}, {0, 0, 1}, 0};
  const Irradiance few = Oracle(Outward(10)).Evaluate(receiver);
  const Irradiance many = Oracle(Outward(20000)).Evaluate(receiver);
  EXPECT_EQ(few.value, many.value);
  EXPECT_EQ(few.statistics, many.statistics);
  EXPECT_GT(few.statistics.blockers, 10U);
}

TEST(SharedBlocks, WhatIsBehindAnotherBlockerIsDropped) {
  // A wall hides half of the lamp, and behind it there are 400 more blockers.
  PortableRandom random(4);
  std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp},
                              {Ceiling(-2, 0, -2, 2, 1), kBlack}};
  for (int i = 0; i < 400; ++i) {
    const double x = random.Uniform(-1.5, -0.5);
    const double y = random.Uniform(-1, 1);
    const double z = random.Uniform(2, 3);
    faces.push_back({{{x, y, z}, {x + 0.2, y, z}, {x, y + 0.2, z}}, kBlack});
  }
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const Irradiance all = Oracle(MakeScene(faces)).Evaluate(receiver);
  EXPECT_EQ(all.statistics.blockers, 1U);
  faces.resize(2);
  EXPECT_EQ(all.value, Evaluate(MakeScene(faces), receiver));
  EXPECT_GT(all.value[0], 0);
}

}  // namespace
}  // namespace truelux
