// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as tiles, each evaluated as one block of receivers.

#ifndef TRUELUX_IMAGE_TILE_GRID_H_
#define TRUELUX_IMAGE_TILE_GRID_H_

#include <algorithm>
#include <cstddef>

#include "base/receiver_block.h"

namespace truelux {

/// A side of the square tiles that are handed to the oracle: a whole tile is
/// one block of receivers.
constexpr int kTileSide = kReceiverBlockSide;

/// Pixels left <= x < right, top <= y < bottom.
struct TileArea {
  int left;
  int top;
  int right;
  int bottom;
};

/// The tiles of a picture, row after row; those at its right and lower sides
/// may be smaller.
class TileGrid {
 public:
  /// width, height [px]: at least 1.
  TileGrid(int width, int height) : width_(width), height_(height) {}

  [[nodiscard]] std::size_t size() const {
    return Across() * TilesAlong(height_);
  }

  /// Requires i < size().
  [[nodiscard]] TileArea operator[](std::size_t i) const {
    const int left = static_cast<int>(i % Across()) * kTileSide;
    const int top = static_cast<int>(i / Across()) * kTileSide;
    return {left, top, std::min(left + kTileSide, width_),
            std::min(top + kTileSide, height_)};
  }

 private:
  static std::size_t TilesAlong(int side) {
    return static_cast<std::size_t>((side + kTileSide - 1) / kTileSide);
  }

  [[nodiscard]] std::size_t Across() const { return TilesAlong(width_); }

  int width_;
  int height_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_TILE_GRID_H_
