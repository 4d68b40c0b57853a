#include "cli/render_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

#include "cli/messages.h"
#include "cli/version.h"
#include "report/exr_image.h"
#include "report/number_text.h"
#include "report/png_image.h"
#include "report/results.h"
#include "report/tone.h"

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
                   kVersion, Name(options.method))},
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

}  // namespace

std::string PictureOf(const RenderRequest& request,
                      const RenderedPixels& pixels) {
  if (request.is_exr) return Exr(request, pixels.image);
  return Photograph(request, pixels.image);
}

std::string ExtraPictureOf(const RenderRequest& request, ExtraImage image,
                           const RenderedPixels& pixels) {
  (void)image;
  return Photograph(request, pixels.image);
}

}  // namespace truelux
