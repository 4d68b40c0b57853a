// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/image_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "image/bitmap_text.h"

namespace truelux {
namespace {

constexpr Rgba8 kPaper = {250, 250, 250, 255};
constexpr Rgba8 kInk = {30, 30, 30, 255};

/// Lengths in dots of the text, which are `scale` pixels each.
constexpr int kMargin = 6;
constexpr int kLine = kGlyphHeight + 4;
constexpr int kBarWidth = 10;
constexpr int kTickLength = 3;
constexpr int kGap = 3;

std::string TickText(double value) {
  return fmt::format("{:.4g}", value);
}

class LegendPainter {
 public:
  LegendPainter(const Raster<Rgba8>& picture, const ImageLegend& legend)
      : legend_(legend),
        scale_(std::clamp((picture.height() + kHeightShift) / kHeightStep, 1,
                          std::max(1, picture.width() / kNarrow))) {
    int width = 0;
    const auto widen = [&](const std::string& text, int left) {
      width = std::max(width, left + TextWidth(text, 1));
    };
    for (const std::string& line : legend.title)
      widen(line, 0);
    if (legend.scale) {
      for (const double tick : legend.scale->ticks())
        widen(TickText(tick), kBarWidth + kTickLength + kGap);
    }
    for (const Swatch& swatch : legend.swatches)
      widen(swatch.text, kBarWidth + kGap);
    left_ = picture.width();
    const int needed = scale_ * NeededHeight();
    result_ = Raster<Rgba8>(left_ + scale_ * (width + 2 * kMargin),
                            std::max(picture.height(), needed));
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x)
        result_.At(x, y) = picture.At(x, y);
    }
    Fill(left_, 0, result_.width(), result_.height(), kPaper);
  }

  Raster<Rgba8> Paint() {
    const int x = left_ + scale_ * kMargin;
    int y = scale_ * kMargin;
    for (const std::string& line : legend_.title) {
      DrawText(result_, x, y, scale_, line, kInk);
      y += scale_ * kLine;
    }
    if (legend_.scale) {
      const int bottom = result_.height() - scale_ * (kMargin + SwatchHeight());
      PaintBar(x, y + scale_ * kGap, bottom - scale_ * kGap);
      y = bottom + scale_ * kGap;
    }
    for (const Swatch& swatch : legend_.swatches) {
      PaintSwatch(x, y, swatch);
      DrawText(result_, x + scale_ * (kBarWidth + kGap), y, scale_, swatch.text,
               kInk);
      y += scale_ * kLine;
    }
    return std::move(result_);
  }

 private:
  // From 480 pixels on a dot is two pixels, from 780 on three, ..
  static constexpr int kHeightStep = 300;
  static constexpr int kHeightShift = 120;
  // A dot is at most a 64th of the picture's width, or a pixel, so that the
  // legend of a tall picture, about 100 dots wide, does not outgrow memory.
  static constexpr int kNarrow = 64;

  [[nodiscard]] int SwatchHeight() const {
    const auto count = static_cast<int>(legend_.swatches.size());
    return count == 0 ? 0 : kLine * count + kGap;
  }

  [[nodiscard]] int NeededHeight() const {
    int height = 2 * kMargin + SwatchHeight() +
                 kLine * static_cast<int>(legend_.title.size());
    if (legend_.scale) {
      height += 2 * kGap +
                kLine * static_cast<int>(legend_.scale->ticks().size() + 1);
    }
    return height;
  }

  void Fill(int left, int top, int right, int bottom, const Rgba8& colour) {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x)
        result_.At(x, y) = colour;
    }
  }

  void PaintSwatch(int x, int y, const Swatch& swatch) {
    const int right = x + scale_ * kBarWidth;
    const int bottom = y + scale_ * kGlyphHeight;
    if (!swatch.is_framed) {
      Fill(x, y, right, bottom, swatch.colour);
      return;
    }
    Fill(x, y, right, bottom, kInk);
    Fill(x + scale_, y + scale_, right - scale_, bottom - scale_,
         swatch.colour);
  }

  /// The scale from `bottom` up to `top`, with half a character of room for
  /// the numbers at its ends.
  void PaintBar(int x, int top, int bottom) {
    const int right = x + scale_ * kBarWidth;
    const int rows = bottom - top - 1;
    for (int y = top; y < bottom; ++y) {
      const double share = static_cast<double>(bottom - 1 - y) / rows;
      Fill(x, y, right, y + 1, FalseColour(share));
    }
    for (const double tick : legend_.scale->ticks()) {
      const auto up = std::lround(legend_.scale->At(tick) * rows);
      const int y = bottom - 1 - static_cast<int>(up);
      Fill(right, y, right + scale_ * kTickLength, y + 1, kInk);
      DrawText(result_, right + scale_ * (kTickLength + kGap),
               y - scale_ * (kGlyphHeight / 2), scale_, TickText(tick), kInk);
    }
  }

  const ImageLegend& legend_;
  int scale_;
  int left_ = 0;
  Raster<Rgba8> result_;
};

}  // namespace

Raster<Rgba8> WithLegend(const Raster<Rgba8>& picture,
                         const ImageLegend& legend) {
  return LegendPainter(picture, legend).Paint();
}

}  // namespace truelux
