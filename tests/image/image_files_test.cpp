// SPDX-License-Identifier: GPL-3.0-or-later
// Picture files, read back by the libraries; colours, scales, legends, lines.

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <png.h>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/bitmap_text.h"
#include "image/exr_image.h"
#include "image/false_colour.h"
#include "image/image_legend.h"
#include "image/isolux.h"
#include "image/png_image.h"
#include "image/tone.h"

namespace truelux {
namespace {

class StringStream : public Imf::IStream {
 public:
  explicit StringStream(std::string bytes)
      : Imf::IStream("memory"), bytes_(std::move(bytes)) {}

  bool read(char* to, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (place_ + size > bytes_.size()) throw std::runtime_error("too short");
    std::memcpy(to, bytes_.data() + place_, size);
    place_ += size;
    return place_ < bytes_.size();
  }

  std::uint64_t tellg() override { return place_; }

  void seekg(std::uint64_t place) override { place_ = place; }

 private:
  std::string bytes_;
  std::uint64_t place_ = 0;
};

TEST(ExrImage, IsReadBackByTheLibrary) {
  IrradianceImage image{Raster<Rgb>(70, 41), Raster<std::uint8_t>(70, 41, 1)};
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 70; ++x)
      image.values.At(x, y) = {x / 3.0, y / 7.0, 1e-3 * x * y};
  }
  image.covered.At(5, 6) = 0;
  image.values.At(7, 8) = {1e300, 3.4028235e38, 1e-46};
  StringStream stream(
      ExrImage(image, std::vector<ImageText>{{"scene", "room.obj"}}));
  Imf::InputFile file(stream);
  const Imf::Header& header = file.header();
  EXPECT_EQ(header.dataWindow().max.x, 69);
  EXPECT_EQ(header.dataWindow().max.y, 40);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("scene").value(),
            "room.obj");
  std::vector<float> pixels(std::size_t{70} * 41 * 4);
  Imf::FrameBuffer buffer;
  const char* const names[] = {"R", "G", "B", "A"};
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_EQ(header.channels()[names[k]].type, Imf::FLOAT);
    buffer.insert(
        names[k],
        Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data() + k), 16,
                   std::size_t{16} * 70));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(0, 40);
  const auto at = [&](int x, int y) {
    const auto i =
        4 * (static_cast<std::size_t>(y) * 70 + static_cast<std::size_t>(x));
    return std::vector<float>(pixels.begin() + static_cast<long>(i),
                              pixels.begin() + static_cast<long>(i) + 4);
  };
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 70; ++x) {
      if ((x == 5 && y == 6) || (x == 7 && y == 8)) continue;
      ASSERT_EQ(at(x, y),
                (std::vector<float>{static_cast<float>(x / 3.0),
                                    static_cast<float>(y / 7.0),
                                    static_cast<float>(1e-3 * x * y), 1}));
    }
  }
  EXPECT_EQ(at(5, 6), (std::vector<float>{0, 0, 0, 0}));
  EXPECT_EQ(at(7, 8),
            (std::vector<float>{std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::max(), 0, 1}));
}

TEST(ExrImage, FloatsAreTheNearest) {
  EXPECT_EQ(NearestFloat(0x1.fffffefffffffp127), 0x1.fffffep127F);
  EXPECT_EQ(NearestFloat(0x1.ffffffp127), HUGE_VALF);  // a tie, to even
  EXPECT_EQ(NearestFloat(HUGE_VAL), HUGE_VALF);
  EXPECT_EQ(NearestFloat(1 + 0x1p-24), 1.0F);
  EXPECT_EQ(NearestFloat(0x1p-150), 0.0F);
}

TEST(PngImage, IsReadBackByTheLibrary) {
  Raster<Rgba8> picture(3, 2, {1, 2, 3, 255});
  picture.At(2, 1) = {200, 100, 50, 0};
  const std::string bytes = PngImage(picture);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(
      png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(image.width, 3U);
  EXPECT_EQ(image.height, 2U);
  image.format = PNG_FORMAT_RGBA;
  std::vector<Rgba8> pixels(6);
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr),
            0);
  EXPECT_EQ(pixels, picture.pixels());
}

TEST(Tone, FollowsTheSrgbCurve) {
  EXPECT_EQ(SrgbCode(-1), 0);
  EXPECT_EQ(SrgbCode(std::nan("")), 0);
  EXPECT_EQ(SrgbCode(0.002), 7);   // 12.92 * 0.002 * 255 = 6.6
  EXPECT_EQ(SrgbCode(0.18), 118);  // middle grey
  EXPECT_EQ(SrgbCode(0.5), 188);
  EXPECT_EQ(SrgbCode(1), 255);
  EXPECT_EQ(SrgbCode(HUGE_VAL), 255);
}

TEST(Tone, WhiteIsAHighQuantileOfWhatIsLit) {
  IrradianceImage image{Raster<Rgb>(20, 10), Raster<std::uint8_t>(20, 10, 1)};
  EXPECT_EQ(AutomaticWhite(image), 1);  // all dark
  for (int i = 0; i < 100; ++i)
    image.values.pixels()[static_cast<std::size_t>(i)] = {0, i + 1.0, 0};
  image.values.At(3, 8) = {HUGE_VAL, 0, 0};
  EXPECT_EQ(AutomaticWhite(image), 99);  // the infinite one does not count
}

/// CIE L* of an sRGB colour, from its definition.
double Lightness(const Rgba8& colour) {
  const auto linear = [](std::uint8_t code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) +
                   0.0722 * linear(colour.blue);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(FalseColour, GrowsLighterInNearlyEqualSteps) {
  EXPECT_EQ(FalseColour(0), (Rgba8{68, 1, 84, 255}));
  EXPECT_EQ(FalseColour(1), (Rgba8{253, 231, 37, 255}));
  EXPECT_EQ(FalseColour(-3), FalseColour(0));
  EXPECT_EQ(FalseColour(7), FalseColour(1));
  EXPECT_EQ(FalseColour(std::nan("")), FalseColour(0));
  const double mean =
      (Lightness(FalseColour(1)) - Lightness(FalseColour(0))) / 16;
  for (int i = 0; i < 16; ++i) {
    const double step = Lightness(FalseColour((i + 1) / 16.0)) -
                        Lightness(FalseColour(i / 16.0));
    EXPECT_GT(step, 0.7 * mean) << i;
    EXPECT_LT(step, 1.35 * mean) << i;
  }
}

TEST(ColourScale, HasRoundTicks) {
  EXPECT_EQ(ColourScale::Linear(0.35).ticks().size(), 8U);  // by 0.05
  EXPECT_DOUBLE_EQ(ColourScale::Linear(0.35).ticks()[3], 0.15);
  EXPECT_EQ(ColourScale::Linear(8).ticks().size(), 9U);
  EXPECT_EQ(ColourScale::Linear(81).ticks().back(), 80);
  EXPECT_EQ(ColourScale::Linear(3, true).ticks(),
            (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(ColourScale::Linear(4).At(1), 0.25);
  EXPECT_EQ(ColourScale::Linear(4).At(HUGE_VAL), 1);
  const ColourScale log = ColourScale::Logarithmic(3e-5, 0.2);
  EXPECT_EQ(log.ticks().size(), 6U);  // 1e-5 .. 1
  EXPECT_NEAR(log.At(1e-3), 0.4, 1e-12);
  EXPECT_EQ(log.At(0), 0);
  EXPECT_EQ(ColourScale::Logarithmic(1e-40, 1).ticks().size(), 9U);
  EXPECT_EQ(ColourScale::Logarithmic(1, 1).ticks().size(), 2U);
}

TEST(Isolux, LinesAreThinOnTheLowerSideAndMirrored) {
  Raster<double> values(9, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 9; ++x)
      values.At(x, y) = 4 - std::abs(x - 4);
  }
  values.At(1, 1) = std::nan("");
  const auto lines = IsoluxLines(values, std::vector<double>{1.5, 3});
  std::string rows;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 9; ++x)
      rows += lines.At(x, y) != 0 ? '#' : '.';
    rows += ' ';
  }
  EXPECT_EQ(rows, ".##...##. ..#...##. .##...##. ");
}

TEST(BitmapText, DrawsDots) {
  Raster<Rgba8> picture(TextWidth("1-", 1), kGlyphHeight);
  DrawText(picture, 0, 0, 1, "1-", {9, 9, 9, 255});
  std::string rows;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      rows += picture.At(x, y).alpha != 0 ? '#' : '.';
    rows += '\n';
  }
  EXPECT_EQ(rows,
            "..#........\n"
            ".##........\n"
            "..#........\n"
            "..#...#####\n"
            "..#........\n"
            "..#........\n"
            ".###.......\n");
  DrawText(picture, -3, -2, 5, "\xff", {1, 1, 1, 255});  // cut, no crash
}

TEST(ImageLegend, LeavesThePictureAsItIs) {
  for (const int size : {1, 30, 600}) {
    const Raster<Rgba8> picture(size, size, {1, 2, 3, 0});
    const Raster<Rgba8> result = WithLegend(
        picture,
        {{"title"}, ColourScale::Linear(1), {{{4, 5, 6, 255}, "swatch"}}});
    EXPECT_GT(result.width(), size + 30);
    EXPECT_GE(result.height(), size);
    bool has_bar = false;
    for (int y = 0; y < result.height(); ++y) {
      for (int x = 0; x < result.width(); ++x) {
        if (picture.Contains(x, y)) {
          EXPECT_EQ(result.At(x, y), picture.At(x, y));
        } else if (x >= size) {
          EXPECT_EQ(result.At(x, y).alpha, 255);
          if (result.At(x, y) == FalseColour(1)) has_bar = true;
        } else {
          EXPECT_EQ(result.At(x, y).alpha, 0);
        }
      }
    }
    EXPECT_TRUE(has_bar);
  }
}

}  // namespace
}  // namespace truelux
