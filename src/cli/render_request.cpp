// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/render_request.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>
#include <variant>

#include "truelux/io.h"
#include "truelux/version.h"

#include "base/ascii_case.h"
#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "run/file_place.h"
#include "run/interrupt.h"
#include "run/user_error.h"
#include "text/results.h"

namespace truelux {
namespace {

/// Pixels on a side: more than any picture that fits kMaxPixels has use for.
constexpr std::int64_t kMaxSide = 65536;

/// A further picture goes beside the output: "image_error.png".
OutputPath BesideOutput(const std::string& output, ExtraPicture extra) {
  std::filesystem::path base = output;
  base.replace_extension();
  return {fmt::format("--also {}", Name(extra)),
          base.string() + "_" + Name(extra) + ".png"};
}

/// Whether the output is an EXR file; otherwise it is a PNG.
bool IsExr(const std::string& output) {
  const std::string extension =
      LowerAscii(std::filesystem::path(output).extension().string());
  if (extension != ".exr" && extension != ".png") {
    throw UsageError(
        fmt::format("--output: '{}' ends with neither .exr nor .png", output));
  }
  return extension == ".exr";
}

void ParseOutputs(const RenderArguments& arguments, RenderRequest& request) {
  const std::string output = PathValue("--output", arguments.output);
  request.style.is_exr = IsExr(output);
  request.outputs = {{"--output", output}};
  const OutputPath receivers_out = {
      "--receivers-out", PathValue("--receivers-out", arguments.receivers_out)};
  const OutputPath values = {"--values",
                             PathValue("--values", arguments.values)};
  for (const OutputPath& table : {receivers_out, values}) {
    if (table.path == "-")
      throw UsageError(fmt::format("{}: '-' is no file", table.option));
    if (!table.path.empty()) request.outputs.push_back(table);
  }
  request.receivers_out = !receivers_out.path.empty();
  request.values = !values.path.empty();
  for (const ExtraPicture extra : kExtraPictures) {
    if (std::ranges::find(arguments.also, Name(extra)) == arguments.also.end())
      continue;
    request.also.push_back(extra);
    request.outputs.push_back(BesideOutput(output, extra));
    Wish(extra, request.wishes);
  }
}

Camera ParseCamera(const RenderArguments& arguments) {
  const auto triple = [](const char* option,
                         const std::optional<std::string>& word) {
    if (!word) {
      throw UsageError(fmt::format(
          "a camera needs --eye, --target, --up and --fov: {} is missing",
          option));
    }
    return TripleValue(option, *word);
  };
  const auto [ex, ey, ez] = triple("--eye", arguments.eye);
  const auto [tx, ty, tz] = triple("--target", arguments.target);
  const auto [ux, uy, uz] = triple("--up", arguments.up);
  if (!arguments.fov) {
    throw UsageError(
        "a camera needs --eye, --target, --up and --fov: --fov is missing");
  }
  const std::optional<double> fov = ParseNumber(*arguments.fov);
  if (!fov) {
    throw UsageError(
        fmt::format("--fov: '{}' is not a number", *arguments.fov));
  }
  const Camera camera{{ex, ey, ez}, {tx, ty, tz}, {ux, uy, uz}, *fov};
  std::string defect;
  if (!CameraFrameOf(camera, defect)) throw UsageError("the camera: " + defect);
  return camera;
}

PictureSubject ParseSubject(const RenderArguments& arguments) {
  const bool has_camera =
      arguments.eye || arguments.target || arguments.up || arguments.fov;
  if (arguments.surface.has_value() == has_camera) {
    throw UsageError(
        "either --surface, or a camera by --eye, --target, --up and --fov");
  }
  if (has_camera) return ParseCamera(arguments);
  if (arguments.surface->empty())
    throw UsageError("--surface: the name is empty");
  return *arguments.surface;
}

/// is_surface: its height may follow from its width.
PictureSize ParseSize(const std::string& text, bool is_surface) {
  const std::size_t cross = text.find('x');
  const auto side = [&](const std::string& word) {
    const std::optional<double> number = ParseNumber(word);
    if (!number || *number < 1 || *number > kMaxSide ||
        *number != std::floor(*number)) {
      throw UsageError(fmt::format(
          "--size: '{}' is not WxH or W, whole numbers from 1 to {}", text,
          kMaxSide));
    }
    return static_cast<int>(*number);
  };
  PictureSize size;
  size.width = side(text.substr(0, cross));
  if (cross != std::string::npos) {
    size.height = side(text.substr(cross + 1));
  } else if (!is_surface) {
    size.height = size.width;
  }
  if (size.height == 0) return size;
  try {
    CheckPixelCount(size.width, size.height);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--") + error.what());
  }
  return size;
}

/// What the picture shows as white; nothing: it is not said.
std::optional<double> ParseWhite(const RenderArguments& arguments) {
  if (arguments.exposure && arguments.white) {
    throw UsageError("--exposure and --white say the same: give one of them");
  }
  if (arguments.exposure) {
    constexpr double kMostStops = 1000;
    const std::optional<double> stops = ParseNumber(*arguments.exposure);
    if (!stops || std::fabs(*stops) > kMostStops) {
      throw UsageError(
          fmt::format("--exposure: '{}' is not a number from -{} to {}",
                      *arguments.exposure, kMostStops, kMostStops));
    }
    return std::exp2(-*stops);
  }
  if (!arguments.white) return std::nullopt;
  const std::optional<double> white = ParseNumber(*arguments.white);
  if (!white || !(*white > 0)) {
    throw UsageError(fmt::format("--white: '{}' is not a positive number",
                                 *arguments.white));
  }
  return white;
}

/// The parser of the command line has refused all other words.
ScalarChannel ChannelOf(const std::string& word) {
  for (const ScalarChannel channel :
       {ScalarChannel::kRed, ScalarChannel::kGreen, ScalarChannel::kBlue}) {
    if (word == Name(channel)) return channel;
  }
  return ScalarChannel::kLuminance;
}

/// How numbers become colours. wishes: of the further pictures.
void ParseColours(const RenderArguments& arguments, const PixelWishes& wishes,
                  PictureStyle& style) {
  style.false_colour = arguments.false_colour;
  style.isolux = !arguments.no_isolux;
  if (style.is_exr && (arguments.exposure || arguments.white ||
                       arguments.false_colour || arguments.no_isolux)) {
    throw UsageError(
        "--exposure, --white, --false-colour and --no-isolux belong to a PNG; "
        "an EXR file holds the numbers themselves");
  }
  if (arguments.no_isolux && !arguments.false_colour) {
    throw UsageError("--no-isolux belongs to --false-colour");
  }
  style.white = ParseWhite(arguments);
  if (!arguments.channel) return;
  if (!style.false_colour && !wishes.differences && !wishes.gradients) {
    throw UsageError(
        "--channel belongs to --false-colour, --also error and --also "
        "gradient");
  }
  style.channel = ChannelOf(*arguments.channel);
}

/// What an EXR file says about itself.
std::vector<ImageText> ExrTexts(const std::string& scene,
                                const OracleOptions& options) {
  return {{"comments",
           fmt::format("irradiance [W/m^2] by truelux {}: the binary64 value "
                       "({}) rounded once more to binary32",
                       VersionText(), Name(options.method))},
          {"scene", std::filesystem::path(scene).filename().string()},
          {"method", std::string(Name(options.method))},
          {"emission", std::string(Name(options.emission))},
          {"engine", std::string(Name(options.engine))}};
}

std::vector<std::string> PixelWords(const RenderArguments& arguments,
                                    const PixelWishes& wishes) {
  std::vector<std::string> words = {arguments.size};
  for (const std::optional<std::string>& word :
       {arguments.surface, arguments.on_face, arguments.eye, arguments.target,
        arguments.up, arguments.fov}) {
    words.push_back(word ? "given " + *word : "");
  }
  for (const bool wish : {wishes.bounds, wishes.differences, wishes.arcs,
                          wishes.classes, wishes.gradients}) {
    words.emplace_back(wish ? "yes" : "no");
  }
  return words;
}

}  // namespace

RenderRequest ParseRenderRequest(const RenderArguments& arguments) {
  RenderRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  ParseOutputs(arguments, request);
  request.subject = ParseSubject(arguments);
  request.on_face = arguments.on_face;
  request.size = ParseSize(
      arguments.size, std::holds_alternative<std::string>(request.subject));
  ParseColours(arguments, request.wishes, request.style);
  request.options.method = MethodOf(arguments.method);
  request.options.engine = EngineOf(arguments.engine);
  request.options.emission = EmissionOf(arguments.emission);
  request.options.stop = InterruptFlag();
  request.threads = ThreadsOf(arguments.threads);
  if (request.wishes.differences &&
      request.options.engine == Engine::kAngularSpans) {
    throw UsageError(
        "--also error compares two sums over arcs; --engine angular-spans has "
        "none");
  }
  request.wishes.bounds =
      request.values && request.options.method == Method::kDouble;
  if (arguments.resume) {
    request.part = FollowLinks(request.outputs.front().path) + ".part";
    request.pixel_words = PixelWords(arguments, request.wishes);
  }
  request.style.texts = ExrTexts(request.scene.path, request.options);
  return request;
}

}  // namespace truelux
