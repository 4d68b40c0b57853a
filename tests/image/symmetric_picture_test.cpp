// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures in which receivers see edges line up exactly: no pixel is wrong.
//
// A square lamp over a square floor, and between them squares whose edges and
// corners line up with the lamp's and with each other as seen from whole rows
// and columns of pixels. The floor is cut into pixels of 1/8 with one in the
// middle, so that every centre is exact and many are on symmetry planes.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"
#include "truelux/raster.h"

#include "explain/shadow_class.h"
#include "image/camera_pixels.h"
#include "image/surface_pixels.h"
#include "support/scenes.h"
#include "surface/surface_frame.h"

namespace truelux {
namespace {

using testing::Ceiling;
using testing::Floor;

constexpr int kSide = 23;

/// Face 1 is the floor. Seen from the floor, what is at height 1 covers twice
/// its size of the lamp's plane.
Scene SymmetricScene() {
  constexpr double kHalf = kSide / 16.0;
  std::vector<testing::TestFace> faces = {
      {Floor(-kHalf, kHalf, -kHalf, kHalf, 0)},
      {Ceiling(-1, 1, -1, 1, 2), testing::kLamp},
      {Floor(-0.25, 0.25, -0.25, 0.25, 1.5)}};
  for (const double x : {-0.5, 0.25}) {
    for (const double y : {-0.5, 0.25})
      faces.push_back({Floor(x, x + 0.25, y, y + 0.25, 1)});
  }
  // Fins in the symmetry planes.
  faces.push_back({{{-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, 1}, {-0.5, 0, 1}}});
  faces.push_back({{{0, -0.5, 0.5}, {0, 0.5, 0.5}, {0, 0.5, 1}, {0, -0.5, 1}}});
  return testing::MakeScene(faces);
}

Raster<Rgb> Picture(const Scene& scene, const PixelReceivers& receivers,
                    Engine engine) {
  OracleOptions options;
  options.engine = engine;
  const Oracle oracle(scene, options);
  Raster<Rgb> picture(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      picture.At(x, y) = oracle.Evaluate(receivers.At(x, y).value()).value;
  }
  return picture;
}

std::array<int, kShadowClassCount> ClassCounts(
    const Scene& scene, const PixelReceivers& receivers) {
  const Oracle oracle(scene);
  std::array<int, kShadowClassCount> counts{};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Receiver receiver = receivers.At(x, y).value();
      ++counts[static_cast<std::size_t>(
          ShadowClassOf(scene, receiver, oracle.Contour(receiver)))];
    }
  }
  return counts;
}

int CountOf(const std::array<int, kShadowClassCount>& counts,
            ShadowClass shadow) {
  return counts[static_cast<std::size_t>(shadow)];
}

/// Both mirrors and the diagonal, bit for bit.
void ExpectSymmetric(const Raster<Rgb>& picture) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Rgb& value = picture.At(x, y);
      EXPECT_EQ(picture.At(kSide - 1 - x, y), value) << x << " " << y;
      EXPECT_EQ(picture.At(x, kSide - 1 - y), value) << x << " " << y;
      EXPECT_EQ(picture.At(y, x), value) << x << " " << y;
    }
  }
}

TEST(SymmetricPicture, OfASurfaceHasNoWrongPixel) {
  const Scene scene = SymmetricScene();
  std::string defect;
  const auto frame = SurfaceFrameOf(scene, std::vector<int>{0}, defect);
  ASSERT_TRUE(frame) << defect;
  const SurfacePixels receivers(scene, *frame, kSide, kSide);
  EXPECT_EQ(receivers.At(kSide / 2, kSide / 2)->position, (Point3{0, 0, 0}));
  EXPECT_EQ(receivers.At(0, 0)->position, (Point3{-1.375, 1.375, 0}));
  const Raster<Rgb> picture = Picture(scene, receivers, Engine::kContour);
  EXPECT_EQ(picture.pixels(),
            Picture(scene, receivers, Engine::kAngularSpans).pixels());
  ExpectSymmetric(picture);
  const auto counts = ClassCounts(scene, receivers);
  EXPECT_GT(CountOf(counts, ShadowClass::kConjunctive), 100);
  EXPECT_GT(CountOf(counts, ShadowClass::kPenumbra), 100);
}

TEST(SymmetricPicture, ThroughACameraHasNoWrongPixel) {
  const Scene scene = SymmetricScene();
  std::string defect;
  // Under all that hangs there.
  const auto frame =
      CameraFrameOf({{0, 0, 0.375}, {0, 0, 0}, {0, 1, 0}, 150}, defect);
  ASSERT_TRUE(frame) << defect;
  const CameraPixels receivers(scene, *frame, kSide, kSide);
  const Raster<Rgb> picture = Picture(scene, receivers, Engine::kContour);
  EXPECT_EQ(picture.pixels(),
            Picture(scene, receivers, Engine::kAngularSpans).pixels());
  ExpectSymmetric(picture);
  const auto counts = ClassCounts(scene, receivers);
  EXPECT_GT(CountOf(counts, ShadowClass::kConjunctive), 30);
}

}  // namespace
}  // namespace truelux
