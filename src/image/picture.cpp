// SPDX-License-Identifier: GPL-3.0-or-later

#include "truelux/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <span>
#include <string>
#include <utility>

#include "image/contour_drawing.h"
#include "image/exr_image.h"
#include "image/image_legend.h"
#include "image/isolux.h"
#include "image/picture_scale.h"
#include "image/png_image.h"
#include "image/scalar_raster.h"
#include "image/tone.h"
#include "text/number_text.h"

namespace truelux {
namespace {

void AddNote(Picture& picture, std::string message) {
  picture.notes.push_back({Severity::kNote, "", 0, std::move(message)});
}

/// How many pixels have a channel of which something holds.
template <class Predicate>
std::ptrdiff_t CountPixels(const IrradianceImage& image,
                           const Predicate& holds) {
  return std::ranges::count_if(image.values.pixels(), [&](const Rgb& value) {
    return std::ranges::any_of(value, holds);
  });
}

void NoteOverflows(const IrradianceImage& image, Picture& picture) {
  const auto count = CountPixels(image, [](double e) { return std::isinf(e); });
  if (count == 0) return;
  AddNote(picture,
          fmt::format("{} pixel{} an irradiance too large for binary64, taken "
                      "as infinite",
                      count, count == 1 ? " has" : "s have"));
}

void MakeExr(const IrradianceImage& image, const PictureStyle& style,
             Picture& picture) {
  const auto lost = CountPixels(image, [](double e) {
    return std::isfinite(e) && std::isinf(NearestFloat(e));
  });
  if (lost > 0) {
    AddNote(picture,
            fmt::format("{} pixel{} an irradiance too large for binary32, "
                        "written as inf",
                        lost, lost == 1 ? " has" : "s have"));
  }
  picture.bytes = ExrImage(image, style.texts);
}

void MakePhotograph(const IrradianceImage& image, const PictureStyle& style,
                    Picture& picture) {
  const double white = style.white ? *style.white : AutomaticWhite(image);
  if (!style.white) {
    AddNote(picture,
            fmt::format("white is {} W/m^2; --white or --exposure sets it",
                        ScientificText(white, 3)));
  }
  picture.bytes = PngImage(Toned(image, white));
}

/// Lines in black where the picture is light, and in white where it is dark.
void DrawIsolux(Raster<Rgba8>& picture, const Raster<double>& values,
                const ColourScale& scale) {
  constexpr double kLight = 0.6;
  constexpr Rgba8 kWhiteLine = {255, 255, 255, 255};
  constexpr Rgba8 kBlackLine = {0, 0, 0, 255};
  // Level 0 is skipped: no pixel is darker than 0.
  const auto levels = std::span(scale.ticks()).subspan(1);
  const Raster<std::uint8_t> lines = IsoluxLines(values, levels);
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (lines.pixels()[i] == 0) continue;
    picture.pixels()[i] =
        scale.At(values.pixels()[i]) < kLight ? kWhiteLine : kBlackLine;
  }
}

void MakeFalseColours(const IrradianceImage& image, const PictureStyle& style,
                      Picture& picture) {
  const PictureScale shown = PictureScaleOf(image, style);
  if (!style.white) {
    AddNote(picture,
            fmt::format("the scale ends at {} W/m^2, the largest value; "
                        "--white or --exposure sets it",
                        ScientificText(shown.top, 3)));
  }
  Raster<Rgba8> colours = Coloured(shown.values, shown.scale);
  if (style.isolux && style.contours) {
    DrawContours(colours, *style.contours, shown.scale);
  } else if (style.isolux) {
    DrawIsolux(colours, shown.values, shown.scale);
  }
  const ImageLegend legend = {
      {fmt::format("E {}", Name(shown.channel)), "[W/m^2]",
       fmt::format("max {:.4g}", shown.largest)},
      shown.scale,
      {}};
  picture.bytes = PngImage(WithLegend(colours, legend));
}

}  // namespace

Picture PictureOf(const IrradianceImage& image, const PictureStyle& style) {
  Picture picture;
  NoteOverflows(image, picture);
  if (style.is_exr) {
    MakeExr(image, style, picture);
  } else if (style.false_colour) {
    MakeFalseColours(image, style, picture);
  } else {
    MakePhotograph(image, style, picture);
  }
  return picture;
}

}  // namespace truelux
