// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels that are kept if a run is interrupted.

#ifndef TRUELUX_IMAGE_PIXEL_PART_H_
#define TRUELUX_IMAGE_PIXEL_PART_H_

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "truelux/rendered_pixels.h"

#include "image/tile_grid.h"
#include "run/part_file.h"

namespace truelux {

/// Pixels to a PartFile, tile after tile in the order in which they are done.
/// A block is the bytes of the rasters as they are in memory: a part belongs to
/// the kind of computer that has written it.
class PixelPart {
 public:
  /// As PartFile; the key has all that the pixels and their number depend on.
  /// grid: of the whole picture.
  PixelPart(const std::string& path, const std::string& key, TileGrid grid);

  [[nodiscard]] const std::string& path() const { return file_.path(); }

  /// Pixels in tiles that are done, those of earlier runs included.
  [[nodiscard]] std::uint64_t done() const { return done_; }

  /// Puts the tiles that earlier runs have done into `pixels`, and says for
  /// every tile whether it is one of these.
  [[nodiscard]] std::vector<bool> Restore(RenderedPixels& pixels) const;

  /// Keeps a tile of `pixels`. Any thread may call it.
  void Take(std::size_t tile, const RenderedPixels& pixels);

  /// After all outputs have their names.
  void Remove() { file_.Remove(); }

 private:
  void Count(std::size_t tile);

  TileGrid grid_;
  std::mutex mutex_;
  std::vector<std::size_t> tiles_;  ///< with done_ before file_, which fills it
  std::uint64_t done_ = 0;
  PartFile file_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PIXEL_PART_H_
