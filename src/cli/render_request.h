// What the words of truelux render ask for.

#ifndef TRUELUX_CLI_RENDER_REQUEST_H_
#define TRUELUX_CLI_RENDER_REQUEST_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "truelux/irradiance.h"

#include "cli/output_paths.h"
#include "image/camera_frame.h"
#include "image/scalar_channel.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct RenderArguments {
  std::string scene;
  std::string output;
  std::optional<std::string> surface;
  std::optional<std::string> eye;
  std::optional<std::string> target;
  std::optional<std::string> up;
  std::optional<std::string> fov;
  std::string size;
  std::optional<std::string> receivers_out;
  std::optional<std::string> values;
  std::vector<std::string> also;
  std::optional<std::string> exposure;
  std::optional<std::string> white;
  bool false_colour = false;
  bool no_isolux = false;
  std::optional<std::string> channel;
  std::string method;
  std::string engine;
  std::string emission;
  std::string threads;
};

/// A further picture beside the irradiance.
enum class ExtraImage {
  kError,  ///< |double - certified|
  kArcs,   ///< number of arcs of the visible contour
  kClass,  ///< lit, umbra, penumbra, ...
};

/// The word of --also and of the file's name.
const char* Name(ExtraImage image);

/// What is to be done.
struct RenderRequest {
  std::string scene;
  std::string output;
  bool is_exr = false;  ///< otherwise a PNG
  std::string surface;  ///< "": see camera
  std::optional<Camera> camera;
  int width = 0;
  int height = 0;                ///< 0: what suits the width
  std::string receivers_out;     ///< path; "": none
  std::string values;            ///< path; "": none
  std::vector<ExtraImage> also;  ///< each once, in the order of the enum
  std::optional<double> white;   ///< [W/m^2]; nothing: automatic
  bool false_colour = false;
  bool isolux = true;
  ScalarChannel channel = ScalarChannel::kLuminance;
  bool channel_given = false;
  OracleOptions options;
  int threads = 1;

  [[nodiscard]] bool Wants(ExtraImage image) const;

  /// Where a further picture goes: beside the output, "image_error.png".
  [[nodiscard]] std::string PathOf(ExtraImage image) const;

  /// All files that are written: the picture, then receivers, values, extra
  /// images as far as they are asked for.
  [[nodiscard]] OutputPaths Outputs() const;
};

/// More pixels would not fit into the memory of many a computer: a picture
/// takes about a hundred bytes a pixel.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;

/// Throws UsageError if the words do not fit together or are no numbers.
RenderRequest ParseRenderRequest(const RenderArguments& arguments);

/// Throws UsageError if a picture has more than kMaxPixels.
void CheckPixelCount(int width, int height);

}  // namespace truelux

#endif  // TRUELUX_CLI_RENDER_REQUEST_H_
