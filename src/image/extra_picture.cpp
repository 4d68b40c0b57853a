// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "truelux/picture.h"
#include "truelux/raster.h"
#include "truelux/render.h"

#include "base/scalar_channel.h"
#include "explain/shadow_class.h"
#include "image/false_colour.h"
#include "image/image_legend.h"
#include "image/kink_lines.h"
#include "image/png_image.h"
#include "image/scalar_raster.h"
#include "text/quantile.h"

namespace truelux {
namespace {

std::string ErrorPicture(const RenderedPixels& pixels,
                         std::optional<ScalarChannel> channel) {
  const Raster<double> values =
      Scalars(pixels.image, pixels.differences, [&](const Rgb& difference) {
        return channel ? ScalarOf(difference, *channel)
                       : *std::ranges::max_element(difference);
      });
  double least = LargestOf(values);
  const double most = least;
  for (const double value : values.pixels()) {
    if (value > 0) least = std::min(least, value);
  }
  const Rgba8 agreed = {150, 150, 150, 255};
  const ColourScale scale = most > 0 ? ColourScale::Logarithmic(least, most)
                                     : ColourScale::Logarithmic(1, 1);
  Raster<Rgba8> picture = Coloured(values, scale);
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    if (values.pixels()[i] == 0) picture.pixels()[i] = agreed;
  }
  ImageLegend legend = {
      {"|double - certified|", channel ? Name(*channel) : "largest channel",
       "[W/m^2]", fmt::format("max {:.2g}", most)},
      scale,
      {{agreed, "no difference"}}};
  if (most == 0) legend.scale.reset();
  return PngImage(WithLegend(picture, legend));
}

/// The scale ends at a quantile: near where an edge touches the surface
/// gradients have no limit. Kinks count from what one of 256 steps of the scale
/// shows.
std::string GradientPicture(const RenderedPixels& pixels,
                            std::optional<ScalarChannel> channel) {
  constexpr double kShown = 0.99;
  constexpr double kSteps = 256;
  const auto shown = [&](const Rgb& length) {
    return channel ? ScalarOf(length, *channel)
                   : *std::ranges::max_element(length);
  };
  const Raster<double> values = Scalars(pixels.image, pixels.gradients, shown);
  std::vector<double> positive;
  for (const double value : values.pixels()) {
    if (value > 0 && std::isfinite(value)) positive.push_back(value);
  }
  const double top =
      positive.empty() ? 1 : Quantile(std::move(positive), kShown);
  const ColourScale scale = ColourScale::Linear(top);
  ImageLegend legend = {
      {"|tangential gradient|", channel ? Name(*channel) : "largest channel",
       "[W/m^3]", fmt::format("max {:.3g}", LargestOf(values))},
      scale,
      {}};
  Raster<Rgba8> picture = Coloured(values, scale);
  if (pixels.kinks && !pixels.kinks->is_left_out) {
    DrawKinkLines(picture, Scalars(pixels.image, pixels.kinks->lengths, shown),
                  top / kSteps);
    legend.swatches.push_back({kKinkColour, "the gradient jumps", true});
    if (pixels.kinks->is_partial)
      legend.title.emplace_back("some kinks not drawn");
  } else if (pixels.kinks) {
    legend.title.emplace_back("kinks not drawn");
  }
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

const char* Name(ExtraPicture extra) {
  switch (extra) {
    case ExtraPicture::kError:
      break;
    case ExtraPicture::kArcs:
      return "arcs";
    case ExtraPicture::kClass:
      return "class";
    case ExtraPicture::kGradient:
      return "gradient";
  }
  return "error";
}

void Wish(ExtraPicture extra, PixelWishes& wishes) {
  switch (extra) {
    case ExtraPicture::kError:
      wishes.differences = true;
      break;
    case ExtraPicture::kArcs:
      wishes.arcs = true;
      break;
    case ExtraPicture::kClass:
      wishes.classes = true;
      break;
    case ExtraPicture::kGradient:
      wishes.gradients = true;
      break;
  }
}

std::string ExtraPictureOf(ExtraPicture extra, const RenderedPixels& pixels,
                           std::optional<ScalarChannel> channel) {
  switch (extra) {
    case ExtraPicture::kError:
      break;
    case ExtraPicture::kArcs:
      return ArcsPicture(pixels);
    case ExtraPicture::kClass:
      return ClassPicture(pixels);
    case ExtraPicture::kGradient:
      return GradientPicture(pixels, channel);
  }
  return ErrorPicture(pixels, channel);
}

}  // namespace truelux
