#include "cli/render_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <span>
#include <vector>

#include "truelux/version.h"

#include "explain/shadow_class.h"
#include "image/exr_image.h"
#include "image/false_colour.h"
#include "image/image_legend.h"
#include "image/isolux.h"
#include "image/png_image.h"
#include "image/scalar_channel.h"
#include "image/tone.h"
#include "run/messages.h"
#include "text/number_text.h"
#include "text/results.h"

namespace truelux {
namespace {

std::string Exr(const RenderRequest& request, const IrradianceImage& image) {
  const OracleOptions& options = request.options;
  const std::string scene =
      std::filesystem::path(request.scene).filename().string();
  const std::vector<ImageText> texts = {
      {"comments",
       fmt::format("irradiance [W/m^2] by truelux {}: the binary64 value "
                   "({}) rounded once more to binary32",
                   VersionText(), Name(options.method))},
      {"scene", scene},
      {"method", std::string(Name(options.method))},
      {"emission", std::string(Name(options.emission))},
      {"engine", std::string(Name(options.engine))}};
  const auto lost =
      std::ranges::count_if(image.values.pixels(), [](const Rgb& value) {
        return std::ranges::any_of(value, [](double e) {
          return std::isfinite(e) && std::isinf(NearestFloat(e));
        });
      });
  if (lost > 0) {
    PrintNote(
        fmt::format("{} pixel{} an irradiance too large for binary32, "
                    "written as inf",
                    lost, lost == 1 ? " has" : "s have"));
  }
  return ExrImage(image, texts);
}

std::string Photograph(const RenderRequest& request,
                       const IrradianceImage& image) {
  double white = request.white.value_or(0);
  if (!request.white) {
    white = AutomaticWhite(image);
    PrintNote(fmt::format("white is {} W/m^2; --white or --exposure sets it",
                          ScientificText(white, 3)));
  }
  return PngImage(Toned(image, white));
}

constexpr Rgba8 kWhiteLine = {255, 255, 255, 255};
constexpr Rgba8 kBlackLine = {0, 0, 0, 255};

/// The pixels that are not NaN by a scale.
Raster<Rgba8> Coloured(const Raster<double>& values, const ColourScale& scale) {
  Raster<Rgba8> picture(values.width(), values.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const double value = values.pixels()[i];
    if (!std::isnan(value)) picture.pixels()[i] = FalseColour(scale.At(value));
  }
  return picture;
}

/// Lines in black where the picture is light, and in white where it is dark.
void DrawIsolux(Raster<Rgba8>& picture, const Raster<double>& values,
                const ColourScale& scale) {
  constexpr double kLight = 0.6;
  // At 0 there is no line: nothing is below.
  const auto levels = std::span(scale.ticks()).subspan(1);
  const Raster<std::uint8_t> lines = IsoluxLines(values, levels);
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (lines.pixels()[i] == 0) continue;
    picture.pixels()[i] =
        scale.At(values.pixels()[i]) < kLight ? kWhiteLine : kBlackLine;
  }
}

/// One number a pixel; NaN where nothing is.
template <class T, class Function>
Raster<double> Scalars(const IrradianceImage& image, const Raster<T>& pixels,
                       const Function& number) {
  Raster<double> values(pixels.width(), pixels.height(), std::nan(""));
  for (std::size_t i = 0; i < values.pixels().size(); ++i) {
    if (image.covered.pixels()[i] != 0)
      values.pixels()[i] = number(pixels.pixels()[i]);
  }
  return values;
}

/// The largest finite number, or 0.
double LargestOf(const Raster<double>& values) {
  double largest = 0;
  for (const double value : values.pixels()) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  return largest;
}

std::string FalseColours(const RenderRequest& request,
                         const IrradianceImage& image) {
  const Raster<double> values = Scalars(
      image, image.values,
      [&](const Rgb& value) { return ScalarOf(value, request.channel); });
  const double largest = LargestOf(values);
  const double top = request.white.value_or(largest > 0 ? largest : 1);
  const ColourScale scale = ColourScale::Linear(top);
  if (!request.white) {
    PrintNote(
        fmt::format("the scale ends at {} W/m^2, the largest value; "
                    "--white or --exposure sets it",
                    ScientificText(top, 3)));
  }
  Raster<Rgba8> picture = Coloured(values, scale);
  if (request.isolux) DrawIsolux(picture, values, scale);
  const ImageLegend legend = {{fmt::format("E {}", Name(request.channel)),
                               "[W/m^2]", fmt::format("max {:.4g}", largest)},
                              scale,
                              {}};
  return PngImage(WithLegend(picture, legend));
}

std::string ErrorPicture(const RenderRequest& request,
                         const RenderedPixels& pixels) {
  const Raster<double> values =
      Scalars(pixels.image, pixels.differences, [&](const Rgb& difference) {
        return request.channel_given ? ScalarOf(difference, request.channel)
                                     : *std::ranges::max_element(difference);
      });
  double least = LargestOf(values);
  const double most = least;
  for (const double value : values.pixels()) {
    if (value > 0) least = std::min(least, value);
  }
  const Rgba8 kAgreed = {150, 150, 150, 255};
  const ColourScale scale = most > 0 ? ColourScale::Logarithmic(least, most)
                                     : ColourScale::Logarithmic(1, 1);
  Raster<Rgba8> picture = Coloured(values, scale);
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (values.pixels()[i] == 0) picture.pixels()[i] = kAgreed;
  }
  ImageLegend legend = {
      {"|double - certified|",
       request.channel_given ? Name(request.channel) : "largest channel",
       "[W/m^2]", fmt::format("max {:.2g}", most)},
      scale,
      {{kAgreed, "no difference"}}};
  if (most == 0) legend.scale.reset();
  return PngImage(WithLegend(picture, legend));
}

std::string ArcsPicture(const RenderedPixels& pixels) {
  const Raster<double> values = Scalars(pixels.image, pixels.arcs,
                                        [](std::int32_t arcs) { return arcs; });
  const double most = LargestOf(values);
  const ColourScale scale = ColourScale::Linear(std::max(most, 1.0), true);
  const ImageLegend legend = {
      {"arcs of the", "visible contour", fmt::format("max {}", most)},
      scale,
      {}};
  return PngImage(WithLegend(Coloured(values, scale), legend));
}

/// By ShadowClass.
constexpr std::array<Rgba8, kShadowClassCount> kClassColours = {
    {{0, 0, 0, 0},
     {140, 140, 140, 255},
     {30, 30, 90, 255},
     {230, 159, 0, 255},
     {120, 200, 240, 255},
     {213, 0, 90, 255}}};

std::string ClassPicture(const RenderedPixels& pixels) {
  Raster<Rgba8> picture(pixels.classes.width(), pixels.classes.height());
  std::array<std::size_t, kShadowClassCount> counts{};
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const auto index = static_cast<std::size_t>(pixels.classes.pixels()[i]);
    picture.pixels()[i] = kClassColours[index];
    ++counts[index];
  }
  ImageLegend legend;
  for (std::size_t k = 1; k < kShadowClassCount; ++k) {
    legend.swatches.push_back(
        {kClassColours[k],
         fmt::format("{}: {} px", Name(static_cast<ShadowClass>(k)),
                     counts[k])});
  }
  return PngImage(WithLegend(picture, legend));
}

}  // namespace

std::string PictureOf(const RenderRequest& request,
                      const RenderedPixels& pixels) {
  if (request.is_exr) return Exr(request, pixels.image);
  return request.false_colour ? FalseColours(request, pixels.image)
                              : Photograph(request, pixels.image);
}

std::string ExtraPictureOf(const RenderRequest& request, ExtraImage image,
                           const RenderedPixels& pixels) {
  switch (image) {
    case ExtraImage::kError:
      break;
    case ExtraImage::kArcs:
      return ArcsPicture(pixels);
    case ExtraImage::kClass:
      return ClassPicture(pixels);
  }
  return ErrorPicture(request, pixels);
}

}  // namespace truelux
