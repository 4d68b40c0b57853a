// Which boxes may meet a given one: bins along both axes, a bit per box.

#ifndef TRUELUX_VISIBILITY_PART_BINS_H_
#define TRUELUX_VISIBILITY_PART_BINS_H_

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/image_box.h"

namespace truelux {

/// Finds boxes that meet another box inside a frame. A bin holds a set of
/// boxes as bits, so that a query is a few unions and one intersection, and
/// finds each box once, in the order of its index. Allocates nothing in the
/// steady state.
class PartBins {
 public:
  /// Bins for boxes of which only what lies in `frame` matters.
  void Build(std::span<const ImageBox> boxes, const ImageBox& frame) {
    words_ = (boxes.size() + kWordBits - 1) / kWordBits;
    bins_ = BinCount(boxes.size());
    x_ = MakeAxis(frame.x_min, frame.x_max);
    y_ = MakeAxis(frame.y_min, frame.y_max);
    x_bits_.assign(bins_ * words_, 0);
    y_bits_.assign(bins_ * words_, 0);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::uint64_t bit = std::uint64_t{1} << (i % kWordBits);
      const std::size_t word = i / kWordBits;
      Mark(x_bits_, x_, boxes[i].x_min, boxes[i].x_max, word, bit);
      Mark(y_bits_, y_, boxes[i].y_min, boxes[i].y_max, word, bit);
    }
  }

  /// Calls visit(index) -> bool for every box that may meet `box` inside the
  /// frame, in the order of the indices, as long as it returns true. Returns
  /// whether it always did.
  template <class Visit>
  bool ForEach(const ImageBox& box, Visit&& visit) const {
    const std::size_t x_first = Bin(x_, box.x_min);
    const std::size_t x_last = Bin(x_, box.x_max);
    const std::size_t y_first = Bin(y_, box.y_min);
    const std::size_t y_last = Bin(y_, box.y_max);
    for (std::size_t word = 0; word < words_; ++word) {
      std::uint64_t in_x = 0;
      for (std::size_t b = x_first; b <= x_last; ++b)
        in_x |= x_bits_[b * words_ + word];
      if (in_x == 0) continue;
      std::uint64_t in_y = 0;
      for (std::size_t b = y_first; b <= y_last; ++b)
        in_y |= y_bits_[b * words_ + word];
      for (std::uint64_t bits = in_x & in_y; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
        if (!visit(word * kWordBits + bit)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t kWordBits = 64;

  /// One direction of the frame.
  struct Axis {
    double origin = 0;
    double scale = 0;
  };

  /// About four boxes a bin; one bin for a few boxes.
  static std::size_t BinCount(std::size_t boxes) {
    return std::clamp(boxes / 4, std::size_t{1}, std::size_t{64});
  }

  [[nodiscard]] Axis MakeAxis(double min, double max) const {
    return {min, static_cast<double>(bins_) / (max - min)};
  }

  /// The bin of a coordinate, clamped to the frame. Not decreasing in x, for
  /// any origin and scale: boxes that meet share a bin on each axis.
  [[nodiscard]] std::size_t Bin(const Axis& axis, double x) const {
    const double position = (x - axis.origin) * axis.scale;
    if (!(position > 0)) return 0;  // NaN, too: 0 times infinity
    const auto last = static_cast<double>(bins_ - 1);
    return position >= last ? bins_ - 1 : static_cast<std::size_t>(position);
  }

  void Mark(std::vector<std::uint64_t>& bits, const Axis& axis, double min,
            double max, std::size_t word, std::uint64_t bit) const {
    const std::size_t last = Bin(axis, max);
    for (std::size_t b = Bin(axis, min); b <= last; ++b)
      bits[b * words_ + word] |= bit;
  }

  std::size_t words_ = 0;
  std::size_t bins_ = 1;
  Axis x_;
  Axis y_;
  std::vector<std::uint64_t> x_bits_;  ///< bins_ sets of words_ words
  std::vector<std::uint64_t> y_bits_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_PART_BINS_H_
