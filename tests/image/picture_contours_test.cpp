// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a picture are where the irradiance has their level, and end at
// walls.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/picture.h"
#include "truelux/render.h"

#include "isolux/lit_floor.h"
#include "isolux/named_floor.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A lamp over a floor of side 4, with a wall at x = 0.7.
Scene WalledFloor() {
  return NamedFloor(
      2,
      {{{{-0.5, -0.5, 1}, {-0.5, 0.5, 1}, {0.5, 0.5, 1}, {0.5, -0.5, 1}},
        {1, 1, 1}},
       {{{0.7, -1, 0}, {0.7, 0.5, 0}, {0.7, 0.5, 0.5}, {0.7, -1, 0.5}}, {}}});
}

/// The place of a pixel coordinate on the floor.
Point3 PlaceOf(const std::array<double, 2>& p, int size) {
  return {-2 + 4 * p[0] / size, 2 - 4 * p[1] / size, 0};
}

class ContoursOfAPicture : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<PictureContour> Contours(int size,
                                                     int threads = 1) const {
    const Rendering rendering = Render(oracle_, "floor", {size, 0}, {});
    return PictureContoursOf(oracle_, "floor", rendering.pixels.image, Style(),
                             threads);
  }

  static PictureStyle Style() {
    PictureStyle style;
    style.false_colour = true;
    style.white = 0.25;
    return style;
  }

  Oracle oracle_ = Oracle(WalledFloor());
};

TEST_F(ContoursOfAPicture, PointsHaveTheirLevel) {
  constexpr int kSize = 200;
  const auto contours = Contours(kSize);
  std::set<double> levels;
  std::size_t count = 0;
  for (const PictureContour& contour : contours) {
    levels.insert(contour.level);
    for (const auto& p : contour.path) {
      const Point3 at = PlaceOf(p, kSize);
      // At the ends of the wall E depends on the direction.
      if (std::hypot(at.x - 0.7, at.y + 1) < 0.02 ||
          std::hypot(at.x - 0.7, at.y - 0.5) < 0.02)
        continue;
      const double e = oracle_.Evaluate({at, {0, 0, 1}, 1}).value[0];
      // Within a fifth of a pixel where the gradient is below 1.
      EXPECT_NEAR(e, contour.level, 0.2 * 4 / kSize) << at.x << ' ' << at.y;
      ++count;
    }
  }
  // Ticks at 0.05, 0.1, .. 0.25; the largest value is 0.24.
  EXPECT_EQ(levels.size(), 4U);
  EXPECT_GT(count, 500U);
  EXPECT_TRUE(std::ranges::is_sorted(contours, {}, &PictureContour::level));
}

TEST_F(ContoursOfAPicture, EndAtTheWallAndDoNotFollowIt) {
  constexpr int kSize = 200;
  const double wall = (0.7 + 2) / 4 * kSize;
  int crossings = 0;
  int along = 0;
  for (const PictureContour& contour : Contours(kSize)) {
    for (std::size_t i = 1; i < contour.path.size(); ++i) {
      const double before = contour.path[i - 1][0] - wall;
      const double after = contour.path[i][0] - wall;
      const Point3 at = PlaceOf(contour.path[i], kSize);
      if (at.y < -0.99 || at.y > 0.49) continue;
      if (before * after < 0) ++crossings;
      if (std::fabs(before) < 0.01 && std::fabs(after) < 0.01) ++along;
    }
  }
  EXPECT_EQ(crossings, 0);
  EXPECT_EQ(along, 0);
}

TEST_F(ContoursOfAPicture, DoNotDependOnThreads) {
  const auto one = Contours(100, 1);
  const auto two = Contours(100, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].path, two[i].path);
}

TEST_F(ContoursOfAPicture, AreDrawnInsteadOfPixelSteps) {
  const Rendering rendering = Render(oracle_, "floor", {100, 0}, {});
  PictureStyle style = Style();
  const std::string steps = PictureOf(rendering.pixels.image, style).bytes;
  style.contours =
      PictureContoursOf(oracle_, "floor", rendering.pixels.image, style);
  const std::string smooth = PictureOf(rendering.pixels.image, style).bytes;
  EXPECT_NE(smooth, steps);
  style.contours->clear();
  const std::string empty = PictureOf(rendering.pixels.image, style).bytes;
  EXPECT_NE(empty, smooth);
  style.isolux = false;
  EXPECT_EQ(PictureOf(rendering.pixels.image, style).bytes, empty);
}

TEST_F(ContoursOfAPicture, RefuseWhatMakesNoSense) {
  const Rendering rendering = Render(oracle_, "floor", {20, 0}, {});
  EXPECT_THROW(
      (void)PictureContoursOf(oracle_, "roof", rendering.pixels.image, Style()),
      std::invalid_argument);
  EXPECT_THROW((void)PictureContoursOf(oracle_, "floor", rendering.pixels.image,
                                       Style(), 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace truelux
