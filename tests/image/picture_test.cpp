// SPDX-License-Identifier: GPL-3.0-or-later
// Which file a style makes of irradiances, and what the notes say.

#include "truelux/picture.h"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/exr_image.h"
#include "image/png_image.h"
#include "image/tone.h"
#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A row of pixels that all have receivers.
IrradianceImage RowOf(const std::vector<Rgb>& values) {
  const auto width = static_cast<int>(values.size());
  IrradianceImage image{Raster<Rgb>(width, 1),
                        Raster<std::uint8_t>(width, 1, 1)};
  image.values.pixels() = values;
  return image;
}

TEST(Picture, APhotographIsTheTonedImage) {
  const IrradianceImage image = RowOf({{0, 0, 0}, {1, 2, 3}, {0.5, 4, 0}});
  PictureStyle style;
  style.white = 2.5;
  const Picture picture = PictureOf(image, style);
  EXPECT_EQ(picture.bytes, PngImage(Toned(image, 2.5)));
  EXPECT_TRUE(picture.notes.empty()) << TextOf(picture.notes);
}

TEST(Picture, TheWhiteLevelIsNotedUnlessItIsGiven) {
  const IrradianceImage image = RowOf({{1, 2, 4}});
  const Picture picture = PictureOf(image, {});
  EXPECT_EQ(picture.bytes, PngImage(Toned(image, 4)));
  EXPECT_EQ(TextOf(picture.notes),
            "note: white is 4.000 W/m^2; --white or --exposure sets it\n");
}

TEST(Picture, AScaleEndsAtTheLargestValueOfItsChannel) {
  const IrradianceImage image = RowOf({{1, 2, 4}, {3, 0, 5}});
  PictureStyle style;
  style.false_colour = true;
  style.channel = ScalarChannel::kRed;
  const Picture automatic = PictureOf(image, style);
  EXPECT_EQ(TextOf(automatic.notes),
            "note: the scale ends at 3.000 W/m^2, the largest value; --white "
            "or --exposure sets it\n");
  style.white = 3;
  const Picture given = PictureOf(image, style);
  EXPECT_TRUE(given.notes.empty());
  EXPECT_EQ(given.bytes, automatic.bytes);
}

TEST(Picture, TheLuminanceIsShownUnlessAChannelIsGiven) {
  const IrradianceImage image = RowOf({{1, 2, 4}, {3, 0, 5}, {0, 9, 0}});
  PictureStyle style;
  style.false_colour = true;
  const std::string bytes = PictureOf(image, style).bytes;
  style.channel = ScalarChannel::kLuminance;
  EXPECT_EQ(PictureOf(image, style).bytes, bytes);
  style.channel = ScalarChannel::kGreen;
  EXPECT_NE(PictureOf(image, style).bytes, bytes);
}

TEST(Picture, IsoluxLinesCanBeLeftOut) {
  const IrradianceImage image = RowOf({{1, 1, 1}, {9, 9, 9}});
  PictureStyle style;
  style.false_colour = true;
  const std::string bytes = PictureOf(image, style).bytes;
  style.isolux = false;
  EXPECT_NE(PictureOf(image, style).bytes, bytes);
}

TEST(Picture, AnExrFileHoldsTheNumbersAndTexts) {
  const IrradianceImage image = RowOf({{1, 2, 4}});
  PictureStyle style;
  style.is_exr = true;
  style.texts = {{"scene", "a.obj"}};
  const Picture picture = PictureOf(image, style);
  EXPECT_EQ(picture.bytes, ExrImage(image, style.texts));
  EXPECT_TRUE(picture.notes.empty()) << TextOf(picture.notes);
}

TEST(Picture, ValuesThatDoNotFitAreCounted) {
  const IrradianceImage image =
      RowOf({{kInfinity, 0, 0}, {0, 1e300, 1e300}, {1, 1e39, 1}, {1, 1, 1}});
  PictureStyle style;
  style.is_exr = true;
  EXPECT_EQ(TextOf(PictureOf(image, style).notes),
            "note: 1 pixel has an irradiance too large for binary64, taken as "
            "infinite\n"
            "note: 2 pixels have an irradiance too large for binary32, written "
            "as inf\n");
  style.is_exr = false;
  style.white = 1;
  EXPECT_EQ(TextOf(PictureOf(image, style).notes),
            "note: 1 pixel has an irradiance too large for binary64, taken as "
            "infinite\n");
}

}  // namespace
}  // namespace truelux
