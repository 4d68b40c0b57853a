// Which receivers a picture that was asked for shows.

#ifndef TRUELUX_CLI_RENDER_VIEW_H_
#define TRUELUX_CLI_RENDER_VIEW_H_

#include <memory>

#include "truelux/scene.h"

#include "cli/render_request.h"
#include "image/pixel_receivers.h"

namespace truelux {

/// The surface's or the camera's receivers. Prints a note if faces of the
/// surface look to different sides. Throws UserError if there is no such
/// surface, if it is not flat, or if it has too many pixels.
std::unique_ptr<PixelReceivers> ReceiversOf(const RenderRequest& request,
                                            const Scene& scene);

}  // namespace truelux

#endif  // TRUELUX_CLI_RENDER_VIEW_H_
