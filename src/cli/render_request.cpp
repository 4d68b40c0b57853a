#include "cli/render_request.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fmt/format.h>

#include "truelux/io.h"

#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "run/user_error.h"

namespace truelux {
namespace {

constexpr std::array kExtraImages = {ExtraImage::kError, ExtraImage::kArcs,
                                     ExtraImage::kClass};

/// Pixels on a side: more than any picture that fits kMaxPixels has use for.
constexpr std::int64_t kMaxSide = 65536;

std::string LowerCase(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

void ParseOutputs(const RenderArguments& arguments, RenderRequest& request) {
  request.output = PathValue("--output", arguments.output);
  const std::string extension =
      LowerCase(std::filesystem::path(request.output).extension().string());
  request.is_exr = extension == ".exr";
  if (!request.is_exr && extension != ".png") {
    throw UsageError(fmt::format(
        "--output: '{}' ends with neither .exr nor .png", request.output));
  }
  request.receivers_out = PathValue("--receivers-out", arguments.receivers_out);
  request.values = PathValue("--values", arguments.values);
  for (const auto& [option, path] :
       {std::pair("--receivers-out", request.receivers_out),
        std::pair("--values", request.values)}) {
    if (path == "-") {
      throw UsageError(fmt::format("{}: '-' is no file", option));
    }
  }
  for (const ExtraImage image : kExtraImages) {
    if (std::ranges::find(arguments.also, Name(image)) != arguments.also.end())
      request.also.push_back(image);
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

void ParseView(const RenderArguments& arguments, RenderRequest& request) {
  const bool has_camera =
      arguments.eye || arguments.target || arguments.up || arguments.fov;
  if (arguments.surface.has_value() == has_camera) {
    throw UsageError(
        "either --surface, or a camera by --eye, --target, --up and --fov");
  }
  if (has_camera) {
    request.camera = ParseCamera(arguments);
    return;
  }
  request.surface = *arguments.surface;
  if (request.surface.empty()) throw UsageError("--surface: the name is empty");
}

void ParseSize(const std::string& text, RenderRequest& request) {
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
  request.width = side(text.substr(0, cross));
  if (cross != std::string::npos) {
    request.height = side(text.substr(cross + 1));
  } else if (request.camera) {
    request.height = request.width;
  }
  if (request.height > 0) CheckPixelCount(request.width, request.height);
}

/// How numbers become colours.
void ParseColours(const RenderArguments& arguments, RenderRequest& request) {
  request.false_colour = arguments.false_colour;
  request.isolux = !arguments.no_isolux;
  if (request.is_exr && (arguments.exposure || arguments.white ||
                         arguments.false_colour || arguments.no_isolux)) {
    throw UsageError(
        "--exposure, --white, --false-colour and --no-isolux belong to a PNG; "
        "an EXR file holds the numbers themselves");
  }
  if (arguments.no_isolux && !arguments.false_colour) {
    throw UsageError("--no-isolux belongs to --false-colour");
  }
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
    request.white = std::exp2(-*stops);
  }
  if (arguments.white) {
    const std::optional<double> white = ParseNumber(*arguments.white);
    if (!white || !(*white > 0)) {
      throw UsageError(fmt::format("--white: '{}' is not a positive number",
                                   *arguments.white));
    }
    request.white = *white;
  }
  if (!arguments.channel) return;
  if (!request.false_colour && !request.Wants(ExtraImage::kError)) {
    throw UsageError("--channel belongs to --false-colour and --also error");
  }
  request.channel_given = true;
  for (const ScalarChannel channel :
       {ScalarChannel::kRed, ScalarChannel::kGreen, ScalarChannel::kBlue}) {
    // The parser of the command line has refused all other words.
    if (*arguments.channel == Name(channel)) request.channel = channel;
  }
}

}  // namespace

const char* Name(ExtraImage image) {
  switch (image) {
    case ExtraImage::kError:
      break;
    case ExtraImage::kArcs:
      return "arcs";
    case ExtraImage::kClass:
      return "class";
  }
  return "error";
}

bool RenderRequest::Wants(ExtraImage image) const {
  return std::ranges::find(also, image) != also.end();
}

std::string RenderRequest::PathOf(ExtraImage image) const {
  std::filesystem::path base = output;
  base.replace_extension();
  return base.string() + "_" + Name(image) + ".png";
}

OutputPaths RenderRequest::Outputs() const {
  OutputPaths outputs = {{"--output", output}};
  if (!receivers_out.empty())
    outputs.push_back({"--receivers-out", receivers_out});
  if (!values.empty()) outputs.push_back({"--values", values});
  for (const ExtraImage image : also) {
    outputs.push_back({fmt::format("--also {}", Name(image)), PathOf(image)});
  }
  return outputs;
}

RenderRequest ParseRenderRequest(const RenderArguments& arguments) {
  RenderRequest request;
  request.scene = PathValue("SCENE.obj", arguments.scene);
  ParseOutputs(arguments, request);
  ParseView(arguments, request);
  ParseSize(arguments.size, request);
  ParseColours(arguments, request);
  request.options.method = MethodOf(arguments.method);
  request.options.engine = EngineOf(arguments.engine);
  request.options.emission = EmissionOf(arguments.emission);
  request.threads = ThreadsOf(arguments.threads);
  if (request.Wants(ExtraImage::kError) &&
      request.options.engine == Engine::kAngularSpans) {
    throw UsageError(
        "--also error compares two sums over arcs; --engine angular-spans has "
        "none");
  }
  return request;
}

void CheckPixelCount(int width, int height) {
  if (std::int64_t{width} * height <= kMaxPixels) return;
  throw UsageError(fmt::format(
      "--size: {} x {} are more than {} pixels, which is the most that a "
      "picture may have (it takes about 100 bytes of memory a pixel)",
      width, height, kMaxPixels));
}

}  // namespace truelux
