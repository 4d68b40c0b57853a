// SPDX-License-Identifier: GPL-3.0-or-later
// Which points of a trace see two lines overlap before a light.

#include "surface/plane_sight.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

/// In the plane x = 0: an edge at height 1 and one at height 2.
const std::vector<PlaneEdge> kEdges = {{{{{0, -1, 1}, {0, 1, 1}}}, 0},
                                       {{{{0, -1, 2}, {0, 1, 2}}}, 1}};

/// A triangle that looks down, and meets the plane x = 0 from y = -1 to 1 at
/// height 4.
const SourceTriangle kLamp = {{{1, -2, 4}, {-1, 0, 4}, {1, 2, 4}}};
const SourceTriangle kLampUpwards = {{kLamp[0], kLamp[2], kLamp[1]}};

bool SeesKink(const std::vector<PlaneEdge>& edges,
              const std::vector<SourceTriangle>& sources, double y,
              double up = 1) {
  const PlaneSight sight(edges, sources, {1, 0, 0}, {0, 0, up}, {0, 7, 0});
  return sight.MayHaveKinkAt({0, y, 0});
}

TEST(PlaneSight, EdgesOverlapBeforeTheLampInARange) {
  // Towards y per height, from t: the upper edge from (-1 - t) / 2 to
  // (1 - t) / 2, the lower one from -1 - t to 1 - t, the lamp from (-1 - t) / 4
  // to (1 - t) / 4. All three overlap where (-1 - t) / 4 < 1 - t, t < 5 / 3.
  for (double t = -2.99; t < 3; t += 0.02)
    EXPECT_EQ(SeesKink(kEdges, {kLamp}, t), std::fabs(t) < 5.0 / 3) << t;
}

TEST(PlaneSight, OneLineIsNone) {
  std::vector<PlaneEdge> edges = kEdges;
  edges[1].line = edges[0].line;
  EXPECT_FALSE(SeesKink(edges, {kLamp}, 0));
  edges.resize(1);
  EXPECT_FALSE(SeesKink(edges, {kLamp}, 0));
}

TEST(PlaneSight, LampsThatLookAwayOrLieBelowAreNone) {
  EXPECT_FALSE(SeesKink(kEdges, {}, 0));
  EXPECT_FALSE(SeesKink(kEdges, {kLampUpwards}, 0));
  EXPECT_FALSE(SeesKink(kEdges, {kLamp}, 0, -1));
  EXPECT_TRUE(SeesKink(kEdges, {kLampUpwards, kLamp}, 0));
}

TEST(PlaneSight, ALampThatOnlyTouchesThePlaneInAPointIsNone) {
  const SourceTriangle aside = {{{1, -2, 4}, {0, 0, 4}, {1, 2, 4}}};
  EXPECT_FALSE(SeesKink(kEdges, {aside}, 0));
}

TEST(PlaneSight, ALampThatTouchesThePlaneInAnEdgeCounts) {
  const SourceTriangle aside = {{{0, -1, 4}, {0, 1, 4}, {1, 0, 4}}};
  const SourceTriangle turned = {{aside[0], aside[2], aside[1]}};
  EXPECT_NE(SeesKink(kEdges, {aside}, 0), SeesKink(kEdges, {turned}, 0));
}

TEST(PlaneSight, AnEdgeThroughTheSurfaceCountsAboveIt) {
  // From (0, 3, -1) up to (0, 1, 1): it stands on y = 2, and is seen from t < 2
  // at the directions from (1 - t) / 1 on, from t > 2 up to it.
  const std::vector<PlaneEdge> edges = {kEdges[1],
                                        {{{{0, 3, -1}, {0, 1, 1}}}, 0}};
  EXPECT_FALSE(SeesKink(edges, {kLamp}, 0));    // lamp up to 1/4, edge from 1
  EXPECT_TRUE(SeesKink(edges, {kLamp}, 1.5));   // up to -1/8, from -1/2
  EXPECT_FALSE(SeesKink(edges, {kLamp}, 2.5));  // from -7/8, up to -3/2
}

}  // namespace
}  // namespace truelux
