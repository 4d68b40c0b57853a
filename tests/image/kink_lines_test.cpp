// SPDX-License-Identifier: GPL-3.0-or-later
// How kinks are drawn.

#include "image/kink_lines.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "truelux/render.h"
#include "truelux/rendered_pixels.h"

#include "image/kink_jumps.h"

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

/// The picture of the gradient, all pixels of it 1, of which one jumps by 2.
std::string PictureWith(std::optional<KinkJumps> kinks) {
  RenderedPixels pixels;
  pixels.image.values = Raster<Rgb>(8, 8);
  pixels.image.covered = Raster<std::uint8_t>(8, 8, 1);
  pixels.gradients = Raster<Rgb>(8, 8, {1, 1, 1});
  pixels.kinks = std::move(kinks);
  return ExtraPictureOf(ExtraPicture::kGradient, pixels, std::nullopt);
}

TEST(KinkLines, PicturesSayWhatIsDrawn) {
  KinkJumps kinks;
  kinks.lengths = Raster<Rgb>(8, 8);
  const std::string none = PictureWith(kinks);
  EXPECT_NE(none, PictureWith(std::nullopt));  // the legend
  // Below and above a 256th of the scale, in one channel.
  kinks.lengths.At(3, 4) = {0, 0.9 / 256, 0};
  EXPECT_EQ(PictureWith(kinks), none);
  kinks.lengths.At(3, 4) = {0, 1.1 / 256, 0};
  const std::string drawn = PictureWith(kinks);
  EXPECT_NE(drawn, none);
  kinks.is_partial = true;
  const std::string partial = PictureWith(kinks);
  EXPECT_NE(partial, drawn);
  kinks.is_left_out = true;
  EXPECT_NE(PictureWith(kinks), partial);
  EXPECT_NE(PictureWith(kinks), PictureWith(std::nullopt));
}

}  // namespace
}  // namespace truelux
