// SPDX-License-Identifier: GPL-3.0-or-later
// From numbers to the bytes of picture files: EXR and PNG. In the library
// truelux_tools.

#ifndef TRUELUX_PICTURE_H_
#define TRUELUX_PICTURE_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/export.h"
#include "truelux/rendered_pixels.h"

namespace truelux {

/// Which number of a colour is shown.
enum class ScalarChannel { kLuminance, kRed, kGreen, kBlue };

/// The word on the command line.
inline const char* Name(ScalarChannel channel) {
  switch (channel) {
    case ScalarChannel::kLuminance:
      break;
    case ScalarChannel::kRed:
      return "r";
    case ScalarChannel::kGreen:
      return "g";
    case ScalarChannel::kBlue:
      return "b";
  }
  return "luminance";
}

/// A text that a file carries under a name.
struct ImageText {
  std::string name;
  std::string text;
};

/// A line on which the channel of a false-colour picture has a value.
struct PictureContour {
  double level = 0;  ///< [W/m^2]
  /// [px] from the left upper corner, y downwards; a closed line ends where it
  /// begins.
  std::vector<std::array<double, 2>> path;
};

/// The look of the picture of the irradiance. An EXR file holds the numbers
/// themselves, so that only `texts` matters there.
struct PictureStyle {
  bool is_exr = false;           ///< otherwise a PNG
  std::vector<ImageText> texts;  ///< what an EXR file carries
  /// What is shown as white, or at the top of the scale [W/m^2], above 0;
  /// nothing: what suits the picture.
  std::optional<double> white;
  bool false_colour = false;  ///< one channel by colours of a scale
  bool isolux = true;         ///< with false_colour: lines at the ticks
  /// These lines, ascending by levels, drawn smoothly and with their numbers
  /// (PictureContoursOf in render.h); nothing: where a level is passed from
  /// pixel to pixel.
  std::optional<std::vector<PictureContour>> contours{};
  /// The channel of false_colour; nothing: the luminance.
  std::optional<ScalarChannel> channel;
};

/// A picture file, and what the user should know about it.
struct Picture {
  std::string bytes;
  /// How many values are too large for binary64 or binary32, and what is shown
  /// as white if the style does not say.
  std::vector<Diagnostic> notes;
};

/// The picture of the irradiance.
[[nodiscard]] TRUELUX_EXPORT Picture PictureOf(const IrradianceImage& image,
                                               const PictureStyle& style);

/// A further picture beside the irradiance.
enum class ExtraPicture {
  kError,     ///< |double - certified|
  kArcs,      ///< number of arcs of the visible contour
  kClass,     ///< lit, umbra, penumbra, ...
  kGradient,  ///< length of the tangential gradient, with its kinks if they
              ///< were found
};

inline constexpr std::array kExtraPictures = {
    ExtraPicture::kError, ExtraPicture::kArcs, ExtraPicture::kClass,
    ExtraPicture::kGradient};

/// The word on the command line and in the file's name.
[[nodiscard]] TRUELUX_EXPORT const char* Name(ExtraPicture extra);

/// The bytes of its PNG file. pixels: rendered with that wish. channel: the one
/// of kError and kGradient; nothing: the largest of each pixel.
[[nodiscard]] TRUELUX_EXPORT std::string ExtraPictureOf(
    ExtraPicture extra, const RenderedPixels& pixels,
    std::optional<ScalarChannel> channel);

}  // namespace truelux

#endif  // TRUELUX_PICTURE_H_
