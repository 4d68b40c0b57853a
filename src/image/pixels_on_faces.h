// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of a picture on other faces than those they show.

#ifndef TRUELUX_IMAGE_PIXELS_ON_FACES_H_
#define TRUELUX_IMAGE_PIXELS_ON_FACES_H_

#include <optional>

#include "truelux/raster.h"
#include "truelux/scene.h"

#include "image/pixel_receivers.h"
#include "run/watch.h"
#include "text/face_choice.h"

namespace truelux {

/// Receivers of pixels whose faces are chosen; where none is found, a pixel
/// keeps the face that it shows.
class PixelsOnFaces : public PixelReceivers {
 public:
  /// Finds all faces. pixels: must outlive the object. Throws Stopped if `watch`
  /// asks for it.
  PixelsOnFaces(const Scene& scene, const PixelReceivers& pixels,
                const FaceChoice& choice, int threads, const Watch& watch);

  /// How faces were found.
  [[nodiscard]] const FoundFaces& found() const { return found_; }

  [[nodiscard]] std::optional<Receiver> At(int x, int y) const override;

 private:
  const PixelReceivers& pixels_;
  Raster<int> faces_;
  FoundFaces found_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PIXELS_ON_FACES_H_
