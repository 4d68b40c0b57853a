// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of a picture as receivers.

#ifndef TRUELUX_IMAGE_PIXEL_RECEIVERS_H_
#define TRUELUX_IMAGE_PIXEL_RECEIVERS_H_

#include <cstdint>
#include <optional>

#include "truelux/receiver.h"

namespace truelux {

/// Which receiver each pixel of a picture shows. Const methods may be called
/// from several threads.
class PixelReceivers {
 public:
  /// width, height [px]: at least 1.
  PixelReceivers(int width, int height) : width_(width), height_(height) {}

  virtual ~PixelReceivers() = default;
  PixelReceivers(const PixelReceivers&) = delete;
  PixelReceivers& operator=(const PixelReceivers&) = delete;

  [[nodiscard]] int width() const { return width_; }

  [[nodiscard]] int height() const { return height_; }

  /// How many pixels there are.
  [[nodiscard]] std::uint64_t size() const {
    return static_cast<std::uint64_t>(width_) *
           static_cast<std::uint64_t>(height_);
  }

  /// The receiver at the centre of a pixel; nothing where no face is. x counts
  /// from the left, y from the top, both from 0. Always the same answer.
  [[nodiscard]] virtual std::optional<Receiver> At(int x, int y) const = 0;

 private:
  int width_;
  int height_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_PIXEL_RECEIVERS_H_
