// SPDX-License-Identifier: GPL-3.0-or-later
// Sources and blockers at the receiver plane.

#include <cmath>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr OracleOptions kTwin{.engine = Engine::kArrangement};
constexpr OracleOptions kSpans{.engine = Engine::kAngularSpans};
constexpr OracleOptions kTable{.formula = Formula::kUnified};

/// The certified value from all engines and both formulas.
Rgb All(const std::vector<TestFace>& faces, const Receiver& r) {
  const Scene scene = MakeScene(faces);
  const Rgb value = Evaluate(scene, r);
  EXPECT_EQ(Evaluate(scene, r, kTwin), value);
  EXPECT_EQ(Evaluate(scene, r, kSpans), value);
  EXPECT_EQ(Evaluate(scene, r, kTable), value);
  return value;
}

Rgb Up(const std::vector<TestFace>& faces) {
  return All(faces, {{0, 0, 0}, {0, 0, 1}, 0});
}

/// A wall at x = 2 that faces the origin, from z0 to z1.
Ring Wall(double z0, double z1) {
  return {{2, -1, z0}, {2, -1, z1}, {2, 1, z1}, {2, 1, z0}};
}

TEST(Horizon, OnlyWhatIsAboveCounts) {
  const Rgb above = Up({{Wall(0, 3), kLamp}});
  EXPECT_GT(above[0], 0);
  EXPECT_EQ(Up({{Wall(-3, 3), kLamp}}), above);
  EXPECT_EQ(Up({{Wall(-0x1p-70, 3), kLamp}}), above);
  EXPECT_EQ(Up({{Wall(-3, 0), kLamp}}), kBlack);
  EXPECT_EQ(Up({{Wall(-3, -1), kLamp}}), kBlack);
}

TEST(Horizon, VertexOnIt) {
  const Ring corner_on = {{2, -1, 1}, {2, 0, 2}, {2, 1, 1}, {2, 0, 0}};
  const Ring cut = {{2, -1, 1}, {2, 0, 2}, {2, 1, 1}, {2, 0, -1}};
  EXPECT_GT(Up({{corner_on, kLamp}})[0], 0);
  EXPECT_GT(Up({{cut, kLamp}})[0], Up({{corner_on, kLamp}})[0]);
  const Ring hanging = {{2, -1, -1}, {2, 0, 0}, {2, 1, -1}};
  EXPECT_EQ(Up({{hanging, kLamp}}), kBlack);
}

TEST(Horizon, BlockersBelowHideNothing) {
  const Rgb open = Up({{Wall(0, 3), kLamp}});
  const Ring fence = {{1, -1, -1}, {1, -1, 0}, {1, 1, 0}, {1, 1, -1}};
  EXPECT_EQ(Up({{Wall(-3, 3), kLamp}, {fence}}), open);
  const Ring higher = {{1, -1, -1}, {1, -1, 0.75}, {1, 1, 0.75}, {1, 1, -1}};
  EXPECT_EQ(Up({{Wall(-3, 3), kLamp}, {higher}}), Up({{Wall(1.5, 3), kLamp}}));
}

TEST(Horizon, HalfSpaceOfABoxAroundTheReceiver) {
  // Everything above emits: E = M, whatever the walls do below.
  std::vector<TestFace> box;
  for (const Ring& ring :
       {Wall(-3, 3), Ring{{-2, 1, -3}, {-2, 1, 3}, {-2, -1, 3}, {-2, -1, -3}},
        Ring{{2, 1, -3}, {2, 1, 3}, {-2, 1, 3}, {-2, 1, -3}},
        Ring{{-2, -1, -3}, {-2, -1, 3}, {2, -1, 3}, {2, -1, -3}},
        Ceiling(-2, 2, -1, 1, 3)}) {
    box.push_back({ring, kLamp});
  }
  EXPECT_EQ(Up(box), kLamp);
  const Receiver tilted{{0.5, 0.25, 0.125}, {1, -2, 3}, 0};
  box.push_back({Floor(-2, 2, -1, 1, -3), kLamp});
  EXPECT_EQ(All(box, tilted), kLamp);
}

TEST(Horizon, ReceiverInThePlaneOfTheSourceSeesNothing) {
  const Ring ceiling = Ceiling(-1, 1, -1, 1, 0);
  EXPECT_EQ(Up({{ceiling, kLamp}}), kBlack);
  EXPECT_EQ(All({{ceiling, kLamp}}, {{5, 0, 0}, {-1, 0, 0}, 0}), kBlack);
}

TEST(Horizon, NormalOfAnyLength) {
  const std::vector<TestFace> faces = {{Wall(-1, 3), kLamp}};
  const Rgb unit = All(faces, {{0, 0, 0}, {1, 2, 2}, 0});
  for (const double s : {3.0, 0x1p-400, 0x1p500}) {
    EXPECT_EQ(All(faces, {{0, 0, 0}, {s, 2 * s, 2 * s}, 0}), unit);
  }
}

TEST(Horizon, SourceTurnedIntoTheReceiverPlane) {
  // An almost edge-on wall: E follows its height, not a threshold.
  double last = 0;
  for (const double z : {0x1p-300, 0x1p-60, 0x1p-30, 0.5}) {
    const Rgb e = Up({{Wall(-1, z), kLamp}});
    EXPECT_GT(e[0], last);
    last = e[0];
  }
}

}  // namespace
}  // namespace truelux
