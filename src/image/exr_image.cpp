// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/exr_image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace truelux {
namespace {

/// Red, green, blue, alpha.
using FloatPixel = std::array<float, 4>;

/// Bytes in memory where OpenEXR writes a file.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}

  void write(const char* bytes, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (place_ + size > bytes_.size()) bytes_.resize(place_ + size);
    bytes_.replace(place_, size, bytes, size);
    place_ += size;
  }

  std::uint64_t tellp() override { return place_; }

  void seekp(std::uint64_t place) override { place_ = place; }

  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::uint64_t place_ = 0;
};

FloatPixel PixelAt(const IrradianceImage& image, int x, int y) {
  if (image.covered.At(x, y) == 0) return {0, 0, 0, 0};
  const Rgb& value = image.values.At(x, y);
  return {NearestFloat(value[0]), NearestFloat(value[1]),
          NearestFloat(value[2]), 1};
}

}  // namespace

float NearestFloat(double value) {
  // Half a unit beyond the largest float; a conversion of more than that is
  // not defined by the language.
  constexpr double kTooLarge = 0x1.ffffffp127;
  if (std::fabs(value) >= kTooLarge) {
    return std::copysign(std::numeric_limits<float>::infinity(),
                         value > 0 ? 1.0F : -1.0F);
  }
  return static_cast<float>(value);
}

std::string ExrImage(const IrradianceImage& image,
                     std::span<const ImageText> texts) {
  const int width = image.values.width();
  const int height = image.values.height();
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const ImageText& text : texts)
    header.insert(text.name, Imf::StringAttribute(text.text));
  constexpr std::array<const char*, 4> kChannels = {"R", "G", "B", "A"};
  std::vector<FloatPixel> row(static_cast<std::size_t>(width));
  Imf::FrameBuffer buffer;
  for (std::size_t k = 0; k < kChannels.size(); ++k) {
    header.channels().insert(kChannels[k], Imf::Channel(Imf::FLOAT));
    // Every row is taken from the same place.
    buffer.insert(
        kChannels[k],
        Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data()->data() + k),
                   sizeof(FloatPixel), 0));
  }
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        row[static_cast<std::size_t>(x)] = PixelAt(image, x, y);
      file.writePixels(1);
    }
  }  // the file is complete when its object is gone
  return stream.Take();
}

}  // namespace truelux
