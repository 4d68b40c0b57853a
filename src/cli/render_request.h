// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of truelux render ask for.

#ifndef TRUELUX_CLI_RENDER_REQUEST_H_
#define TRUELUX_CLI_RENDER_REQUEST_H_

#include <optional>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/picture.h"
#include "truelux/render.h"

#include "cli/input_arguments.h"
#include "cli/output_paths.h"
#include "image/picture_view.h"
#include "image/render_pixels.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct RenderArguments {
  SceneArguments scene;
  std::string output;
  std::optional<std::string> surface;
  std::optional<std::string> on_face;
  std::optional<std::string> eye;
  std::optional<std::string> target;
  std::optional<std::string> up;
  std::optional<std::string> fov;
  std::string size;
  std::optional<std::string> receivers_out;
  std::optional<std::string> values;
  std::vector<std::string> also;
  bool resume = false;
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

/// What is to be done, as plain values.
struct RenderRequest {
  SceneRequest scene;
  OracleOptions options;
  int threads = 1;
  PictureSubject subject;
  std::optional<std::string> on_face;  ///< for OnFaceOf
  PictureSize size;
  PixelWishes wishes;
  PictureStyle style;
  /// All files that are written: the picture, then receivers, values and extra
  /// pictures as far as they are asked for.
  OutputPaths outputs;
  bool receivers_out = false;
  bool values = false;
  std::vector<ExtraPicture> also;  ///< each once, in the order of the enum
  std::string part;                ///< path of what --resume keeps; "": none
  /// The words of the command line that pixels depend on, besides `options`
  /// and `scene`.
  std::vector<std::string> pixel_words;
};

/// Throws UsageError if the words do not fit together or are no numbers.
RenderRequest ParseRenderRequest(const RenderArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_RENDER_REQUEST_H_
