// SPDX-License-Identifier: GPL-3.0-or-later
// Contours have the ink that is seen on their colour, and numbers in their gaps.

#include "image/contour_drawing.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

constexpr Rgba8 kGrey = {100, 100, 100, 255};

Raster<Rgba8> GreyPicture(int width, int height) {
  Raster<Rgba8> picture(width, height);
  for (Rgba8& pixel : picture.pixels())
    pixel = kGrey;
  return picture;
}

PictureContour Circle(double level, double x, double y, double radius) {
  PictureContour contour;
  contour.level = level;
  for (int i = 0; i <= 180; ++i) {
    const double angle = 2 * std::numbers::pi * i / 180;
    contour.path.push_back(
        {x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return contour;
}

/// How many pixels are whiter, and how many blacker, than grey.
std::array<int, 2> InkOf(const Raster<Rgba8>& picture) {
  std::array<int, 2> counts{};
  for (const Rgba8& pixel : picture.pixels()) {
    if (pixel.red > kGrey.red) ++counts[0];
    if (pixel.red < kGrey.red) ++counts[1];
  }
  return counts;
}

TEST(ContourDrawing, InkIsWhiteOnDarkColoursAndBlackOnLightOnes) {
  const ColourScale scale = ColourScale::Linear(1);
  Raster<Rgba8> dark = GreyPicture(100, 100);
  DrawContours(dark, std::vector{Circle(0.2, 50, 50, 30)}, scale);
  EXPECT_GT(InkOf(dark)[0], 150);
  EXPECT_EQ(InkOf(dark)[1], 0);
  Raster<Rgba8> light = GreyPicture(100, 100);
  DrawContours(light, std::vector{Circle(0.8, 50, 50, 30)}, scale);
  EXPECT_EQ(InkOf(light)[0], 0);
  EXPECT_GT(InkOf(light)[1], 150);
}

/// Pixels within `reach` of a circle that are drawn, and those farther away.
std::array<int, 2> AtCircle(const Raster<Rgba8>& picture, double radius,
                            double reach) {
  std::array<int, 2> counts{};
  const double middle = picture.width() / 2.0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (picture.At(x, y).red == kGrey.red) continue;
      const double r = std::hypot(x + 0.5 - middle, y + 0.5 - middle);
      ++counts[std::fabs(r - radius) <= reach ? 0 : 1];
    }
  }
  return counts;
}

TEST(ContourDrawing, NumbersStandInGapsOfLargePicturesOnly) {
  const ColourScale scale = ColourScale::Linear(1);
  Raster<Rgba8> small = GreyPicture(150, 150);
  DrawContours(small, std::vector{Circle(0.2, 75, 75, 60)}, scale);
  EXPECT_EQ(AtCircle(small, 60, 2)[1], 0);
  Raster<Rgba8> large = GreyPicture(400, 400);
  DrawContours(large, std::vector{Circle(0.2, 200, 200, 150)}, scale);
  const auto [on, beside] = AtCircle(large, 150, 2);
  EXPECT_GT(beside, 20);   // digits are higher than the line
  EXPECT_LT(beside, 300);  // and few
  EXPECT_EQ(AtCircle(large, 150, 6)[1], 0);
  EXPECT_GT(on, 2 * 3.14 * 150 * 0.8);
}

TEST(ContourDrawing, LinesGrowWithThePicture) {
  const ColourScale scale = ColourScale::Linear(1);
  Raster<Rgba8> picture = GreyPicture(150, 150);
  DrawContours(picture, std::vector{Circle(0.2, 75, 75, 60)}, scale);
  Raster<Rgba8> huge = GreyPicture(2400, 2400);
  DrawContours(huge, std::vector{Circle(0.2, 1200, 1200, 960)}, scale);
  // Sixteen times as long, four times as wide.
  const double ratio = static_cast<double>(InkOf(huge)[0]) / InkOf(picture)[0];
  EXPECT_GT(ratio, 30);
  EXPECT_LT(ratio, 64);
}

}  // namespace
}  // namespace truelux
