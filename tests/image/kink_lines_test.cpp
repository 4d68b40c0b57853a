// SPDX-License-Identifier: GPL-3.0-or-later
// How kinks are drawn.

#include "image/kink_lines.h"

#include <cmath>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(KinkLines, AreWhiteBetweenDarkerPixels) {
  const Rgba8 colour = {100, 50, 200, 255};
  Raster<Rgba8> picture(5, 3, colour);
  picture.At(3, 1) = {};
  Raster<double> jumps(5, 3, 0.0);
  jumps.At(2, 1) = 4;
  jumps.At(0, 0) = 1;
  jumps.At(4, 2) = std::nan("");
  DrawKinkLines(picture, jumps, 2);
  const Rgba8 dark = {40, 20, 80, 255};
  EXPECT_EQ(picture.At(2, 1), kKinkColour);
  EXPECT_EQ(picture.At(1, 1), dark);
  EXPECT_EQ(picture.At(2, 0), dark);
  EXPECT_EQ(picture.At(2, 2), dark);
  EXPECT_EQ(picture.At(3, 1), Rgba8{});
  EXPECT_EQ(picture.At(0, 0), colour);
  EXPECT_EQ(picture.At(1, 0), colour);
  EXPECT_EQ(picture.At(4, 2), colour);
}

TEST(KinkLines, LinesSideBySideStayWhite) {
  Raster<Rgba8> picture(2, 1, {9, 9, 9, 255});
  DrawKinkLines(picture, Raster<double>(2, 1, 3.0), 3);
  EXPECT_EQ(picture.At(0, 0), kKinkColour);
  EXPECT_EQ(picture.At(1, 0), kKinkColour);
}

}  // namespace
}  // namespace truelux
