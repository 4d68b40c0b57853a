// From numbers to the bytes of picture files.

#ifndef TRUELUX_CLI_RENDER_PICTURES_H_
#define TRUELUX_CLI_RENDER_PICTURES_H_

#include <string>

#include "cli/render_request.h"
#include "image/render_pixels.h"

namespace truelux {

/// The picture of the irradiance. Prints notes: what is shown as white if that
/// was not asked for, and how many values binary32 cannot hold.
std::string PictureOf(const RenderRequest& request,
                      const RenderedPixels& pixels);

/// A further one.
std::string ExtraPictureOf(const RenderRequest& request, ExtraImage image,
                           const RenderedPixels& pixels);

}  // namespace truelux

#endif  // TRUELUX_CLI_RENDER_PICTURES_H_
