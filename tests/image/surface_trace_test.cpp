// SPDX-License-Identifier: GPL-3.0-or-later
// Over which pixels of a surface a plane's trace runs, and where in them.

#include "image/surface_trace.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/surface_pixels.h"
#include "support/scene_text.h"

namespace truelux {
namespace {

struct Surface {
  explicit Surface(const std::string& obj, int width, int height)
      : scene(SceneFromText(obj)),
        frame(*SurfaceFrameOf(scene, std::vector<int>{0}, defect)),
        pixels(scene, frame, width, height) {}

  Scene scene;
  std::string defect;
  SurfaceFrame frame;
  PixelPlane pixels;
};

/// 8 x 4, without the corner beyond x + y = 10; 16 x 8 pixels of 1/2.
Surface Floor() {
  return Surface("v 0 0 0\nv 8 0 0\nv 8 2 0\nv 6 4 0\nv 0 4 0\nf 1 2 3 4 5\n",
                 16, 8);
}

TEST(PixelPlane, HasTheCentresOfSurfacePixels) {
  const Surface surface("v 0.1 0.2 0.3\nv 3 1 1\nv 2.3 4.8 2\nf 1 2 3\n", 7, 9);
  const SurfacePixels receivers(surface.scene, surface.frame, 7, 9);
  int compared = 0;
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 7; ++x) {
      const auto receiver = receivers.At(x, y);
      EXPECT_EQ(surface.pixels.Covers(x, y), receiver.has_value());
      if (!receiver) continue;
      ++compared;
      const Point3 p = surface.pixels.PointAt(x, y);
      EXPECT_EQ(p, receiver->position);
      const Point3 near = surface.pixels.NearPointAt(x, y);
      EXPECT_NEAR(near.x, p.x, 1e-14);
      EXPECT_NEAR(near.z, p.z, 1e-14);
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(PixelPlane, CoversTheFacesOnly) {
  const Surface surface = Floor();
  EXPECT_TRUE(surface.pixels.Covers(-0.499, 7.499));
  EXPECT_FALSE(surface.pixels.Covers(-0.501, 7));
  EXPECT_FALSE(surface.pixels.Covers(0, 7.501));
  EXPECT_TRUE(surface.pixels.Covers(13.4, 1.4));  // at (6.95, 3.05)
  EXPECT_FALSE(surface.pixels.Covers(13.6, 1.4));
}

TEST(PixelPlane, CountsTheDigitsBelowAPixel) {
  // Pixels of 1/2, coordinates up to 8 in units of 2^-49.
  EXPECT_EQ(Floor().pixels.BitsPerPixel(), 48);
}

TEST(SurfaceTrace, ALevelPlaneHasNone) {
  EXPECT_FALSE(SurfaceTrace::Of(Floor().pixels, {0, 0, 3}, 1));
}

TEST(SurfaceTrace, AFlatLineHasOnePlaceAColumn) {
  // y = x / 4 + 1, from z.
  const Surface surface = Floor();
  const auto trace = SurfaceTrace::Of(surface.pixels, {-1, 4, 5}, 4);
  ASSERT_TRUE(trace);
  const auto steps = trace->Steps();
  ASSERT_EQ(steps.size(), 16U);
  const mpq_class aside(1, 1024);
  for (int x = 0; x < 16; ++x) {
    const SurfaceTrace::Step& step = steps[static_cast<std::size_t>(x)];
    EXPECT_EQ(step.x, x);
    const auto place = trace->At(step, 0);
    const Point3 p = surface.pixels.PointAt(place.x, place.y);
    EXPECT_EQ(p.y, p.x / 4 + 1);
    EXPECT_LE(std::fabs(step.near_y - step.y), 0.5);
    EXPECT_NEAR(step.near_y, place.y.get_d(), 1e-12);
    // A pixel is 1/2 high, and y falls downwards.
    const auto below = trace->At(step, aside);
    EXPECT_EQ(surface.pixels.PointAt(below.x, below.y).y, p.y - 1.0 / 2048);
  }
}

TEST(SurfaceTrace, ASteepLineHasOnePlaceARowWithinThePicture) {
  const Surface surface = Floor();
  const auto steep = SurfaceTrace::Of(surface.pixels, {2, 1, 0}, 17);
  ASSERT_TRUE(steep);
  // x = (17 - y) / 2 is within 8 from y = 1 on.
  const auto steps = steep->Steps();
  ASSERT_EQ(steps.size(), 6U);
  for (const SurfaceTrace::Step& step : steps) {
    const auto place = steep->At(step, 0);
    const Point3 p = surface.pixels.PointAt(place.x, place.y);
    EXPECT_EQ(p.x, (17 - p.y) / 2);
    EXPECT_EQ(place.y, step.y);
  }
}

}  // namespace
}  // namespace truelux
