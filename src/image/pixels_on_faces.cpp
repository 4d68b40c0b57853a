// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/pixels_on_faces.h"

#include <cstddef>
#include <vector>

#include "run/parallel.h"

namespace truelux {

PixelsOnFaces::PixelsOnFaces(const Scene& scene, const PixelReceivers& pixels,
                             const FaceChoice& choice, int threads,
                             const Watch& watch)
    : PixelReceivers(pixels.width(), pixels.height()),
      pixels_(pixels),
      faces_(pixels.width(), pixels.height(), 0) {
  std::vector<FoundFaces> found(static_cast<std::size_t>(height()));
  Progress progress(found.size(), "rows", watch);
  ForEachInParallel(found.size(), threads, progress, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width(); ++x) {
      std::optional<Receiver> receiver = pixels.At(x, y);
      if (!receiver) continue;
      const int own = receiver->on_face;
      SetFace(scene, choice, *receiver, found[row]);
      faces_.At(x, y) = receiver->on_face > 0 ? receiver->on_face : own;
    }
  });
  for (const FoundFaces& of_row : found)
    found_ += of_row;
}

std::optional<Receiver> PixelsOnFaces::At(int x, int y) const {
  std::optional<Receiver> receiver = pixels_.At(x, y);
  if (receiver) receiver->on_face = faces_.At(x, y);
  return receiver;
}

}  // namespace truelux
