// SPDX-License-Identifier: GPL-3.0-or-later
// One value for each pixel of a picture.

#ifndef TRUELUX_RASTER_H_
#define TRUELUX_RASTER_H_

#include <cstddef>
#include <vector>

namespace truelux {

/// Pixels by rows, from the top; x counts from the left, y from the top, both
/// from 0. Different pixels may be written by different threads (but not of
/// bool).
template <class T>
class Raster {
 public:
  Raster() = default;  ///< no pixels

  Raster(int width, int height, const T& value = T{})
      : width_(width),
        height_(height),
        pixels_(
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            value) {}

  [[nodiscard]] int width() const { return width_; }

  [[nodiscard]] int height() const { return height_; }

  [[nodiscard]] bool empty() const { return pixels_.empty(); }

  [[nodiscard]] bool Contains(int x, int y) const {
    return x >= 0 && x < width_ && y >= 0 && y < height_;
  }

  [[nodiscard]] const T& At(int x, int y) const { return pixels_[Index(x, y)]; }

  [[nodiscard]] T& At(int x, int y) { return pixels_[Index(x, y)]; }

  /// All of them, row after row.
  [[nodiscard]] const std::vector<T>& pixels() const { return pixels_; }

  [[nodiscard]] std::vector<T>& pixels() { return pixels_; }

 private:
  [[nodiscard]] std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> pixels_;
};

}  // namespace truelux

#endif  // TRUELUX_RASTER_H_
