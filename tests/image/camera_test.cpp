// SPDX-License-Identifier: GPL-3.0-or-later
// Where a pinhole camera looks.

#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "image/camera_frame.h"
#include "image/camera_pixels.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using testing::Floor;
using testing::MakeScene;

std::string DefectOf(const Camera& camera) {
  std::string defect;
  EXPECT_FALSE(CameraFrameOf(camera, defect));
  return defect;
}

CameraFrame FrameOf(const Camera& camera) {
  std::string defect;
  return CameraFrameOf(camera, defect).value();
}

TEST(CameraFrame, RightAnglesAreExact) {
  const CameraFrame frame = FrameOf({{0, 0, 9}, {0, 0, 5}, {0, 7, 1}, 90});
  EXPECT_EQ(frame.half_height, 1);
  EXPECT_EQ(frame.forward, (Vector3{0, 0, -1}));
  EXPECT_EQ(frame.right, (Vector3{1, 0, 0}));
  EXPECT_EQ(frame.up, (Vector3{0, 1, 0}));
  // The left upper pixel of three by three looks to (-2/3, 2/3, -1).
  EXPECT_EQ(frame.DirectionThrough(0, 0, 3, 3), (Vector3{-2, 2, -3}));
  EXPECT_EQ(frame.DirectionThrough(2, 1, 3, 3), (Vector3{2, 0, -3}));
  EXPECT_EQ(frame.DirectionThrough(4, 0, 5, 1), (Vector3{4, 0, -1}));
}

TEST(CameraFrame, TheTangentIsRoundedOnce) {
  const auto tangent = [](double fov) {
    return FrameOf({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, fov}).half_height;
  };
  EXPECT_EQ(tangent(60), 0x1.279a74590331cp-1);   // 1 / sqrt 3
  EXPECT_EQ(tangent(120), 0x1.bb67ae8584caap+0);  // sqrt 3
  EXPECT_GT(tangent(std::nextafter(180, 0)), 1e15);
}

TEST(CameraFrame, MirroredPixelsHaveMirroredDirections) {
  const CameraFrame frame = FrameOf({{1, 2, 3}, {1, 5, -7}, {0, 1, 0}, 37.123});
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 33; ++x) {
      const Vector3 d = frame.DirectionThrough(x, y, 33, 20);
      EXPECT_EQ(frame.DirectionThrough(32 - x, y, 33, 20),
                (Vector3{-d.x, d.y, d.z}));
    }
  }
}

TEST(CameraFrame, SaysWhatIsNoCamera) {
  EXPECT_EQ(DefectOf({{1, 2, 3}, {1, 2, 3}, {0, 1, 0}, 40}),
            "the eye and the target are the same point");
  EXPECT_EQ(DefectOf({{0, 0, 0}, {0, 0, 1}, {0, 0, 0}, 40}),
            "the up vector is zero");
  EXPECT_EQ(DefectOf({{0, 0, 0}, {1, 2, 3}, {-0.1 * 5, -1, -1.5}, 40}),
            "the up vector is parallel to the line of sight");
  for (const double fov : {0.0, -1.0, 180.0, 200.0, std::nan("")}) {
    EXPECT_EQ(DefectOf({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, fov}),
              "the field of view is not between 0 and 180 degrees");
  }
  // All but parallel is no reason to refuse.
  const CameraFrame frame = FrameOf({{0, 0, 0}, {0, 0, 1}, {0, 1e-300, 1}, 40});
  EXPECT_EQ(frame.up, (Vector3{0, 1, 0}));
}

TEST(CameraPixels, SeeTheFirstFaceFromTheirSide) {
  // A floor, and above half of it a smaller one seen from its front.
  const Scene scene = MakeScene(
      {{testing::Reversed(Floor(-4, 4, -4, 4, 0))}, {Floor(0, 2, 0, 2, 1)}});
  const CameraPixels pixels(
      scene, FrameOf({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 90}), 10, 10);
  const auto corner = pixels.At(0, 9);
  EXPECT_FALSE(corner);  // at (-4.5, -4.5)
  const auto lower = pixels.At(1, 8);
  ASSERT_TRUE(lower);
  EXPECT_EQ(lower->position, (Point3{-3.5, -3.5, 0}));
  EXPECT_EQ(lower->normal, (Vector3{0, 0, 1}));  // its back is seen
  EXPECT_EQ(lower->on_face, 1);
  const auto upper = pixels.At(6, 3);  // x right, y up
  ASSERT_TRUE(upper);
  EXPECT_EQ(upper->on_face, 2);
  EXPECT_EQ(upper->position, (Point3{0.3 * 4, 0.3 * 4, 1}));
  EXPECT_EQ(pixels.At(6, 6)->on_face, 1);
  EXPECT_EQ(pixels.At(3, 3)->on_face, 1);
}

}  // namespace
}  // namespace truelux
