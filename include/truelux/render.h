// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance over a surface, or as a camera sees it, a receiver a pixel: truelux
// render for arrays. In the library truelux_tools.

#ifndef TRUELUX_RENDER_H_
#define TRUELUX_RENDER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/picture.h"
#include "truelux/progress.h"
#include "truelux/raster.h"
#include "truelux/receiver.h"
#include "truelux/rendered_pixels.h"

namespace truelux {

/// Where a camera is and how it looks.
struct Camera {
  Point3 eye;
  Point3 target;  ///< the point in the middle of the picture
  Vector3 up;     ///< what is above the middle; of any length
  double fov =
      0;  ///< from the lower to the upper edge of the picture [degrees]
};

/// What a picture shows: a flat surface by the name of its object or group, or what
/// a camera sees.
using PictureSubject = std::variant<std::string, Camera>;

/// More pixels would not fit into the memory of many a computer: a picture
/// takes about a hundred bytes a pixel.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;

/// The size of a picture [px].
struct PictureSize {
  int width = 0;
  int height = 0;  ///< 0: pixels of a surface are about square
};

/// What is wanted besides the irradiance (RenderedPixels).
struct PixelWishes {
  bool bounds = false;
  bool differences = false;  ///< |double - certified|
  bool arcs = false;
  bool classes = false;
  bool gradients = false;  ///< lengths of tangential gradients
};

/// Sets the wish that the picture needs.
TRUELUX_EXPORT void Wish(ExtraPicture extra, PixelWishes& wishes);

/// How a picture is rendered, and who watches. What asks the call to end is the
/// oracle's stop flag.
struct RenderOptions {
  PixelWishes wishes{};
  /// The face that receivers lie on, as truelux eval's --on-face: "auto", a
  /// face's number, or the name of an object or group; nothing: the face that
  /// each pixel shows.
  std::optional<std::string> on_face{};
  int threads = 1;  ///< 1 .. 1024
  ProgressHook progress{};
};

/// What a picture shows.
struct Rendering {
  RenderedPixels pixels;
  Raster<Receiver> receivers;     ///< without meaning where nothing is
  std::vector<Diagnostic> notes;  ///< what the user should know
};

/// Evaluates one receiver a pixel, at its centre. By `oracle`: its method,
/// engine, emission and stop flag. The result does not depend on threads.
///
/// Throws std::invalid_argument if there is no such surface or it is not flat,
/// if the camera cannot see, if there are more than kMaxPixels, if on_face names
/// nothing, if differences are wished for of Engine::kAngularSpans, or if the
/// number of threads is outside its range; and Stopped.
[[nodiscard]] TRUELUX_EXPORT Rendering Render(const Oracle& oracle,
                                              const PictureSubject& subject,
                                              const PictureSize& size,
                                              const RenderOptions& options);

/// The contours that PictureOf draws on a false-colour picture of a surface, at
/// the ticks of its scale. Each vertex is certified within a fifth of a pixel;
/// closed lines smaller than about nine pixels may be missed (isolux.h proves
/// which there are). They are of the surface's own faces. image, style: as
/// PictureOf takes them, image as Render has it for this surface. Throws as
/// Render does.
[[nodiscard]] TRUELUX_EXPORT std::vector<PictureContour> PictureContoursOf(
    const Oracle& oracle, const std::string& surface,
    const IrradianceImage& image, const PictureStyle& style, int threads = 1,
    const ProgressHook& progress = {});

}  // namespace truelux

#endif  // TRUELUX_RENDER_H_
