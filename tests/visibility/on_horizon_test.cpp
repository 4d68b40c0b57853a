// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/on_horizon.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// Whether the vertex (2, y, z) of a triangle is on the horizon of the origin.
bool IsOn(double y, double z, const Vector3& normal) {
  const Scene scene = MakeScene({{{{2, y, z}, {2, 5, 2}, {2, -5, 3}}, kLamp}});
  ContourVertex vertex;
  vertex.kind = VertexKind::kIntrinsic;
  vertex.vertex = 0;
  return IsOnHorizon(scene, {{0, 0, 0}, normal, 0}, vertex);
}

TEST(IsOnHorizon, TellsTheLastBitOfASceneVertex) {
  EXPECT_TRUE(IsOn(-1, 0, {0, 0, 1}));
  EXPECT_FALSE(IsOn(-1, 0x1p-1000, {0, 0, 1}));
  EXPECT_FALSE(IsOn(-1, -0x1p-1000, {0, 0, 1}));
  EXPECT_TRUE(IsOn(1, 0.1, {0.05, 0, -1}));
  EXPECT_TRUE(IsOn(3, 1, {0, 0.25, -0.75}));
  // As binary64, three times 0.1 is not 0.3.
  EXPECT_FALSE(IsOn(3, 1, {0, 0.1, -0.3}));
}

TEST(IsOnHorizon, BelievesTheKindOfOtherVertices) {
  const Scene scene = MakeScene({{Ceiling(-1, 1, -1, 1, 1), kLamp}});
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  ContourVertex vertex;
  vertex.vertex = -1;
  vertex.kind = VertexKind::kHorizon;
  EXPECT_TRUE(IsOnHorizon(scene, receiver, vertex));
  vertex.kind = VertexKind::kApparent;
  EXPECT_FALSE(IsOnHorizon(scene, receiver, vertex));
}

}  // namespace
}  // namespace truelux
