// From pixels to irradiances, over threads.

#ifndef TRUELUX_CLI_RENDER_PIXELS_H_
#define TRUELUX_CLI_RENDER_PIXELS_H_

#include <cstdint>
#include <optional>

#include "truelux/irradiance.h"

#include "cli/progress.h"
#include "report/irradiance_image.h"
#include "report/pixel_receivers.h"
#include "report/raster.h"
#include "report/shadow_class.h"

namespace truelux {

/// What is wanted besides the irradiance.
struct PixelWishes {
  bool bounds = false;
  /// The same scene by the other method, for |double - certified|.
  std::optional<Oracle> other;
  bool arcs = false;
  bool classes = false;
};

/// What pixels have; a raster that is not wished for is empty.
struct RenderedPixels {
  IrradianceImage image;
  Raster<Rgb> bounds;         ///< as in Irradiance
  Raster<Rgb> differences;    ///< |value - the other method's|
  Raster<std::int32_t> arcs;  ///< 0 where there is no receiver
  Raster<ShadowClass> classes;
};

/// Evaluates the receivers of all pixels. The result does not depend on the
/// number of threads. Counts pixels in `progress`, those without a receiver,
/// too. Throws Interruption within one receiver per thread after the program
/// was interrupted.
RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            Progress& progress);

}  // namespace truelux

#endif  // TRUELUX_CLI_RENDER_PIXELS_H_
