// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by vertices: identities over all of them, differences of the
// certified irradiance, one-sided ones, jumps.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// The faces with one coordinate of one vertex changed: of all corners that are
/// there.
std::vector<TestFace> WithMoved(std::vector<TestFace> faces,
                                const Point3& vertex, std::size_t axis,
                                double step) {
  for (TestFace& face : faces) {
    for (Point3& p : face.ring) {
      if (p != vertex) continue;
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += step;
    }
  }
  return faces;
}

class OfVertices : public ::testing::TestWithParam<int> {
 protected:
  OfVertices()
      : random_(static_cast<std::uint64_t>(GetParam()) + 300),
        faces_(RandomScene(random_, false, 12)),
        scene_(MakeScene(faces_)),
        receiver_(RandomReceiver(random_, false)),
        found_(Oracle(scene_).VertexDerivatives(receiver_)) {}

  PortableRandom random_;
  std::vector<TestFace> faces_;
  Scene scene_;
  Receiver receiver_;
  VertexDerivatives found_;
};

// All vertices together: the receiver moves the other way.
TEST_P(OfVertices, SumToTheGradient) {
  const Derivatives d = Oracle(scene_).Derivatives(receiver_);
  EXPECT_EQ(found_.irradiance.value, d.irradiance.value);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::array<double, 3> sum{};
    double size = 1e-9;
    double scale = 0;
    for (const VertexDerivative& vertex : found_.vertices) {
      const Point3& p =
          scene_.vertices()[static_cast<std::size_t>(vertex.number - 1)];
      const std::array<double, 3> arm = {p.x - receiver_.position.x,
                                         p.y - receiver_.position.y,
                                         p.z - receiver_.position.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const VertexSlope& slope = vertex.slopes[channel][axis];
        ASSERT_TRUE(slope.IsSmooth());
        sum[axis] += slope.left;
        size = std::max(size, std::fabs(slope.left));
        // Scaling the scene around r changes nothing.
        scale += arm[axis] * slope.left;
      }
    }
    const Vector3& g = d.channels[channel].gradient;
    EXPECT_NEAR(sum[0], -g.x, 1e-13 * size);
    EXPECT_NEAR(sum[1], -g.y, 1e-13 * size);
    EXPECT_NEAR(sum[2], -g.z, 1e-13 * size);
    EXPECT_NEAR(scale, 0, 1e-12 * size);
  }
}

TEST_P(OfVertices, DifferencesApproachThem) {
  constexpr double kStep = 0x1p-20;
  int checked = 0;
  for (const VertexDerivative& vertex : found_.vertices) {
    if (++checked > 6) break;
    const Point3& p =
        scene_.vertices()[static_cast<std::size_t>(vertex.number - 1)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [&](double step) {
        return Evaluate(MakeScene(WithMoved(faces_, p, axis, step)), receiver_);
      };
      const Rgb after = at(kStep);
      const Rgb before = at(-kStep);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(vertex.slopes[channel][axis].left,
                    (after[channel] - before[channel]) / (2 * kStep), 1e-5)
            << vertex.number;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OfVertices, ::testing::Range(0, 25));

const VertexSlope& SlopeOf(const VertexDerivatives& found, int number,
                           std::size_t axis) {
  static const VertexSlope nothing;
  for (const VertexDerivative& vertex : found.vertices) {
    if (vertex.number == number) return vertex.slopes[0][axis];
  }
  return nothing;
}

/// A scene whose faces name their vertices.
class NumberedScene {
 public:
  void Add(const Ring& ring, const Rgb& emission,
           const std::vector<int>& numbers) {
    builder_.SetVertexNumbers(numbers);
    builder_.AddFace(ring, emission);
  }

  Scene Build() { return *builder_.Build().value; }

 private:
  SceneBuilder builder_;
};

// A quad of two triangles: with vertices in common nothing opens between them;
// with vertices of their own pulling one opens a gap, and pushing hides.
TEST(VertexDerivatives, VerticesInOnePlaceAreNotOneVertex) {
  const Point3 a = {-1, -1, 2};
  const Point3 b = {-1, 1, 2};
  const Point3 c = {1, 1, 2};
  const Point3 d = {1, -1, 2};
  const Receiver receiver{{0.25, 0.125, 0}, {0, 0, 1}, 0};
  NumberedScene shared;
  shared.Add({a, b, c}, kLamp, {1, 2, 3});
  shared.Add({a, c, d}, kLamp, {1, 3, 4});
  const VertexDerivatives smooth =
      Oracle(shared.Build()).VertexDerivatives(receiver);
  EXPECT_TRUE(SlopeOf(smooth, 1, 0).IsSmooth());
  NumberedScene apart;
  apart.Add({a, b, c}, kLamp, {1, 2, 3});
  apart.Add({a, c, d}, kLamp, {4, 5, 6});
  const VertexDerivatives torn =
      Oracle(apart.Build()).VertexDerivatives(receiver);
  const VertexSlope& slope = SlopeOf(torn, 1, 0);
  EXPECT_FALSE(slope.IsSmooth());
  EXPECT_NE(slope.left, slope.right);
  EXPECT_TRUE(SlopeOf(torn, 2, 0).IsSmooth());
  EXPECT_NEAR(SlopeOf(torn, 2, 0).left, SlopeOf(smooth, 2, 0).left, 1e-15);
}

// Of two lamps in one plane the first is seen; lifted it hides behind the
// other, and E jumps.
TEST(VertexDerivatives, OverlapsInOnePlaneJump) {
  NumberedScene scene;
  scene.Add(Ceiling(-1, 1, -1, 1, 2), {1, 1, 1}, {1, 2, 3, 4});
  scene.Add(Ceiling(-3, 3, -3, 3, 2), {4, 4, 4}, {5, 6, 7, 8});
  const VertexDerivatives found =
      Oracle(scene.Build()).VertexDerivatives({{0.1, 0.2, 0}, {0, 0, 1}, 0});
  const VertexSlope& up = SlopeOf(found, 1, 2);
  EXPECT_TRUE(up.right_jumps);
  EXPECT_FALSE(up.left_jumps);
  EXPECT_TRUE(SlopeOf(found, 1, 0).IsSmooth());
}

TEST(VertexDerivatives, ABlockerOnTheEdgeOfTheLampIsOneSided) {
  NumberedScene scene;
  scene.Add(Ceiling(0, 2, -1, 1, 2), kLamp, {1, 2, 3, 4});
  scene.Add(Ceiling(0, 0.5, -1, 1, 1), kBlack, {5, 6, 7, 8});
  const VertexDerivatives found =
      Oracle(scene.Build()).VertexDerivatives({{0, 0, 0}, {0, 0, 1}, 0});
  // The lamp's edge appears when it is pulled out from behind the blocker.
  const VertexSlope& lamp = SlopeOf(found, 1, 0);
  EXPECT_LT(lamp.left, 0);
  EXPECT_EQ(lamp.right, 0);
  // The blocker's edge hides nothing more when it moves out.
  const VertexSlope& blocker = SlopeOf(found, 5, 0);
  EXPECT_EQ(blocker.left, 0);
  EXPECT_GT(blocker.right, 0);
}

}  // namespace
}  // namespace truelux
