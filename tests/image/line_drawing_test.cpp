// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth lines cover as much as they are wide, and nothing far from them.

#include "image/line_drawing.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

constexpr Rgba8 kRed = {255, 0, 0, 255};

Raster<Rgba8> BlackPicture(int width, int height) {
  Raster<Rgba8> picture(width, height);
  for (Rgba8& pixel : picture.pixels())
    pixel = {0, 0, 0, 255};
  return picture;
}

/// What is covered in all, in pixels.
double CoveredOf(const Raster<Rgba8>& picture) {
  double sum = 0;
  for (const Rgba8& pixel : picture.pixels())
    sum += pixel.red / 255.0;
  return sum;
}

TEST(LineDrawing, AStraightLineThroughMiddlesIsExact) {
  Raster<Rgba8> picture = BlackPicture(20, 9);
  DrawLines(picture, std::vector<PaperPath>{{{3.5, 4.5}, {12.5, 4.5}}}, 1,
            kRed);
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(picture.At(x, 4).red, x >= 3 && x <= 12 ? 255 : 0) << x;
    EXPECT_EQ(picture.At(x, 3).red, 0);
    EXPECT_EQ(picture.At(x, 5).red, 0);
  }
}

TEST(LineDrawing, BetweenRowsBothGetHalf) {
  Raster<Rgba8> picture = BlackPicture(20, 9);
  DrawLines(picture, std::vector<PaperPath>{{{-5, 4}, {25, 4}}}, 1, kRed);
  for (int x = 0; x < 20; ++x) {
    EXPECT_NEAR(picture.At(x, 3).red, 127.5, 1);
    EXPECT_NEAR(picture.At(x, 4).red, 127.5, 1);
    EXPECT_EQ(picture.At(x, 2).red, 0);
  }
}

TEST(LineDrawing, CoversItsAreaAtAnyAngle) {
  for (const double angle : {0.0, 0.3, 0.7, 1.1, 1.5}) {
    for (const double width : {1.0, 2.5, 6.0}) {
      Raster<Rgba8> picture = BlackPicture(100, 100);
      const double reach = 30;
      const PaperPoint way = {reach * std::cos(angle), reach * std::sin(angle)};
      DrawLines(picture,
                std::vector<PaperPath>{
                    {{50 - way.x, 50 - way.y}, {50 + way.x, 50 + way.y}}},
                width, kRed);
      // With round ends.
      const double area = 2 * reach * width + 3.14159 * width * width / 4;
      EXPECT_NEAR(CoveredOf(picture), area, 0.02 * area + 0.5)
          << angle << ' ' << width;
    }
  }
}

TEST(LineDrawing, LinesThatMeetAreNoDarkerThere) {
  Raster<Rgba8> picture = BlackPicture(30, 30);
  DrawLines(picture, std::vector<PaperPath>{{{5, 4.7}, {15, 4.7}, {25, 4.7}}},
            1, kRed);
  EXPECT_EQ(picture.At(14, 4).red, picture.At(10, 4).red);
  EXPECT_EQ(picture.At(15, 4).red, picture.At(10, 4).red);
}

TEST(LineDrawing, TransparentPixelsStay) {
  Raster<Rgba8> picture(10, 10);
  DrawLines(picture, std::vector<PaperPath>{{{0, 5}, {10, 5}}}, 3, kRed);
  for (const Rgba8& pixel : picture.pixels()) {
    EXPECT_EQ(pixel.red, 0);
    EXPECT_EQ(pixel.alpha, 0);
  }
}

TEST(LineDrawing, WhatIsFarOutsideIsLeftOut) {
  Raster<Rgba8> picture = BlackPicture(10, 10);
  DrawLines(picture,
            std::vector<PaperPath>{{{1e300, 5}, {2e300, 5}},
                                   {{-1e9, -20}, {1e9, -20}},
                                   {{3, 1e12}, {3, 2e12}}},
            3, kRed);
  EXPECT_EQ(CoveredOf(picture), 0);
}

}  // namespace
}  // namespace truelux
