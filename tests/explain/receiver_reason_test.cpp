// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/receiver_reason.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/scenes.h"

namespace truelux {
namespace {

using testing::Ceiling;
using testing::kBlack;
using testing::kLamp;
using testing::MakeScene;
using testing::TestFace;

const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

ReceiverTraits Traits(const std::vector<TestFace>& faces,
                      const Receiver& receiver = kUp) {
  const Scene scene = MakeScene(faces);
  return TraitsOf(scene, receiver, Oracle(scene).Contour(receiver));
}

std::string Reason(const std::vector<TestFace>& faces,
                   const Receiver& receiver = kUp) {
  return TextOf(Traits(faces, receiver));
}

const TestFace kSquare{Ceiling(-1, 1, -1, 1, 1), kLamp};

TEST(ReceiverReason, Unlit) {
  EXPECT_EQ(Reason({kSquare}, {{0, 0, 2}, {0, 0, 1}, 0}), "unlit");
  // Behind the source's plane, and with all of it below the horizon.
  EXPECT_EQ(Reason({kSquare}, {{0, 0, 0}, {0, 0, -1}, 0}), "unlit");
}

TEST(ReceiverReason, UmbraIfASourceIsThereButHidden) {
  const TestFace roof{Ceiling(-1, 1, -1, 1, 0.5), kBlack};
  EXPECT_EQ(Reason({kSquare, roof}), "umbra");
  const Scene scene = MakeScene({kSquare, roof});
  const Oracle twin(scene, {.engine = Engine::kArrangement});
  EXPECT_EQ(ReasonOf(scene, kUp, twin.Contour(kUp)), "umbra");
}

TEST(ReceiverReason, FullyLitWithTheFactsOfASquare) {
  const ReceiverTraits traits = Traits({kSquare});
  EXPECT_EQ(TextOf(traits), "fully lit, 4 arcs");
  EXPECT_EQ(traits.sources, 1);
  // A corner is sqrt(2) away from the middle, at height 1.
  const double corner = std::atan(std::sqrt(2.0));
  EXPECT_NEAR(traits.extent, 2 * corner, 1e-14);
  EXPECT_NEAR(traits.highest, std::numbers::pi / 2 - corner, 1e-14);
  EXPECT_NEAR(*traits.lowest, traits.highest, 1e-14);
  EXPECT_NEAR(traits.cancellation, 1, 1e-14);
}

TEST(ReceiverReason, ANeighbourOnTheSameEdgeCastsNoShadow) {
  EXPECT_EQ(Reason({kSquare, {Ceiling(1, 3, -1, 1, 1), kBlack}}),
            "fully lit, 4 arcs");
  EXPECT_EQ(Reason({{Ceiling(1, 3, -1, 1, 1), kBlack}, kSquare}),
            "fully lit, 4 arcs");
}

TEST(ReceiverReason, Penumbra) {
  EXPECT_EQ(Reason({kSquare, {Ceiling(0.1, 2, -2, 2, 0.5), kBlack}}),
            "penumbra, 4 arcs");
}

TEST(ReceiverReason, TheHorizonIsNoShadow) {
  const TestFace wall{{{1, 1, -1}, {1, -1, -1}, {1, -1, 2}, {1, 1, 2}}, kLamp};
  const ReceiverTraits traits = Traits({wall});
  EXPECT_EQ(TextOf(traits), "fully lit, 4 arcs (1 on the horizon)");
  EXPECT_EQ(traits.horizon_arcs, 1);
  EXPECT_GT(*traits.lowest, 0.5);
}

TEST(ReceiverReason, TinySource) {
  const double a = 1e-5;
  const std::string reason = Reason({{Ceiling(-a, a, -a, a, 1), kLamp}});
  EXPECT_EQ(reason, "fully lit, 4 arcs; tiny source (3e-5 rad)");
}

TEST(ReceiverReason, WhatIsOnlyRoundingIsSaidToBe) {
  const double a = 1e-20;
  const std::string reason = Reason({{Ceiling(-a, a, -a, a, 1), kLamp}});
  EXPECT_NE(reason.find("tiny source (under 1e-15 rad)"), std::string::npos)
      << reason;
}

TEST(ReceiverReason, SliverBetweenTwoBlockers) {
  const ReceiverTraits traits =
      Traits({kSquare,
              {Ceiling(-4, -1e-6, -4, 4, 0.5), kBlack},
              {Ceiling(1e-6, 4, -4, 4, 0.5), kBlack}});
  EXPECT_EQ(traits.lighting, Lighting::kPenumbra);
  EXPECT_NEAR(traits.width, 4e-6, 2e-6);
  EXPECT_NE(TextOf(traits).find("sliver ("), std::string::npos)
      << TextOf(traits);
}

TEST(ReceiverReason, Conjunction) {
  // Three edges of blockers meet in one direction inside the source.
  const std::string reason =
      Reason({kSquare,
              {{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}}, kBlack},
              {{{-0.25, 0, 0.25}, {0.25, 0, 0.25}, {0, -1, 0.25}}, kBlack}});
  EXPECT_NE(reason.find("conjunction"), std::string::npos) << reason;
  EXPECT_NE(reason.find(" planes)"), std::string::npos) << reason;
}

TEST(ReceiverReason, GrazingAtTheHorizon) {
  const double h = 1e-4;
  const TestFace low{{{1, 1, 0}, {1, -1, 0}, {1, -1, h}, {1, 1, h}}, kLamp};
  const std::string reason = Reason({low});
  EXPECT_NE(reason.find("grazing (highest vertex"), std::string::npos)
      << reason;
  // A vertex just above the horizon, one exactly on it.
  const TestFace tilted{{{1, 1, 0}, {1, -1, 1e-9}, {1, -1, 2}, {1, 1, 2}},
                        kLamp};
  const ReceiverTraits traits = Traits({tilted});
  ASSERT_TRUE(traits.lowest.has_value());
  EXPECT_NEAR(*traits.lowest, 1e-9 / std::sqrt(2.0), 1e-18);
  EXPECT_NE(TextOf(traits).find("grazing horizon (lowest vertex 7e-10 rad"),
            std::string::npos)
      << TextOf(traits);
}

TEST(ReceiverReason, Cancellation) {
  // Seen under a grazing angle of a strip: the terms of its long edges cancel.
  const ReceiverTraits traits =
      Traits({{Ceiling(-0.5, 0.5, 2, 2.001, 1), kLamp}});
  EXPECT_GT(traits.cancellation, kCancellation);
  EXPECT_NE(TextOf(traits).find("cancellation (terms "), std::string::npos);
}

TEST(ReceiverReason, SeveralSources) {
  EXPECT_EQ(Reason({{Ceiling(-2, -1, -1, 1, 1), kLamp},
                    {Ceiling(1, 2, -1, 1, 1), kLamp}}),
            "fully lit, 2 sources, 8 arcs");
}

TEST(ReceiverReason, NormalsOfAnyLength) {
  const ReceiverTraits unit = Traits({kSquare});
  const ReceiverTraits huge = Traits({kSquare}, {{0, 0, 0}, {0, 0, 1e300}, 0});
  EXPECT_EQ(unit.highest, huge.highest);
  EXPECT_EQ(TextOf(unit), TextOf(huge));
}

}  // namespace
}  // namespace truelux
