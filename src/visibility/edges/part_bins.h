// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes may meet a given one: bins along both axes, a bit per box.

#ifndef TRUELUX_VISIBILITY_EDGES_PART_BINS_H_
#define TRUELUX_VISIBILITY_EDGES_PART_BINS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/edges/bin_axis.h"
#include "visibility/edges/image_box.h"

namespace truelux {

/// Finds boxes that meet another box inside a frame. For every bin of an axis
/// there is the set, as bits, of the boxes that begin there or before, and of
/// those that end there or after: a query is one intersection of four sets,
/// and finds each box once, in the order of its index. Allocates nothing in
/// the steady state.
class PartBins {
 public:
  /// Bins for boxes of which only what lies in `frame` matters.
  void Build(std::span<const ImageBox> boxes, const ImageBox& frame) {
    words_ = (boxes.size() + kWordBits - 1) / kWordBits;
    bins_ = std::clamp(boxes.size() / 2, std::size_t{1}, std::size_t{64});
    x_.Start(frame.x_min(), frame.x_max(), bins_, words_);
    y_.Start(frame.y_min(), frame.y_max(), bins_, words_);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      x_.Mark(i, boxes[i].x_min(), boxes[i].x_max());
      y_.Mark(i, boxes[i].y_min(), boxes[i].y_max());
    }
    x_.Finish();
    y_.Finish();
  }

  /// Calls visit(index) -> bool for every box that may meet `box` inside the
  /// frame, in the order of the indices, as long as it returns true. Returns
  /// whether it always did.
  template <class Visit>
  bool ForEach(const ImageBox& box, Visit&& visit) const {
    return Intersect({x_.BeginUpTo(box.x_max()), x_.EndFrom(box.x_min()),
                      y_.BeginUpTo(box.y_max()), y_.EndFrom(box.y_min())},
                     visit);
  }

  /// The same for every box that may contain what of `box` is in the frame.
  template <class Visit>
  bool ForEachAround(const ImageBox& box, Visit&& visit) const {
    return Intersect({x_.BeginUpTo(box.x_min()), x_.EndFrom(box.x_max()),
                      y_.BeginUpTo(box.y_min()), y_.EndFrom(box.y_max())},
                     visit);
  }

 private:
  template <class Visit>
  bool Intersect(const std::array<const std::uint64_t*, 4>& sets,
                 Visit& visit) const {
    for (std::size_t word = 0; word < words_; ++word) {
      std::uint64_t bits =
          sets[0][word] & sets[1][word] & sets[2][word] & sets[3][word];
      for (; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
        if (!visit(word * kWordBits + bit)) return false;
      }
    }
    return true;
  }

  static constexpr std::size_t kWordBits = 64;

  /// One direction of the frame.
  class Axis {
   public:
    void Start(double min, double max, std::size_t bins, std::size_t words) {
      axis_.Start(min, max, bins);
      words_ = words;
      begin_.assign(bins * words, 0);
      end_.assign(bins * words, 0);
    }

    void Mark(std::size_t box, double min, double max) {
      const std::uint64_t bit = std::uint64_t{1} << (box % kWordBits);
      begin_[axis_.Bin(min) * words_ + box / kWordBits] |= bit;
      end_[axis_.Bin(max) * words_ + box / kWordBits] |= bit;
    }

    /// Makes the sets of the bins cumulative.
    void Finish() {
      for (std::size_t i = words_; i < begin_.size(); ++i)
        begin_[i] |= begin_[i - words_];
      for (std::size_t i = end_.size(); i-- > words_;)
        end_[i - words_] |= end_[i];
    }

    /// The boxes that may begin at x or before.
    [[nodiscard]] const std::uint64_t* BeginUpTo(double x) const {
      return begin_.data() + axis_.Bin(x) * words_;
    }

    /// The boxes that may end at x or after.
    [[nodiscard]] const std::uint64_t* EndFrom(double x) const {
      return end_.data() + axis_.Bin(x) * words_;
    }

   private:
    BinAxis axis_;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> begin_;  ///< bins_ sets of words_ words
    std::vector<std::uint64_t> end_;
  };

  std::size_t words_ = 0;
  std::size_t bins_ = 1;
  Axis x_;
  Axis y_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_PART_BINS_H_
