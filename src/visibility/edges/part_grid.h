// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many small boxes may contain a given one: the cells of a grid, each
// with the boxes in it.

#ifndef TRUELUX_VISIBILITY_EDGES_PART_GRID_H_
#define TRUELUX_VISIBILITY_EDGES_PART_GRID_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/edges/bin_axis.h"
#include "visibility/edges/image_box.h"

namespace truelux {

/// Finds boxes that contain another box inside a frame. What a query costs does
/// not grow with the number of boxes elsewhere, as it does with sets of bits
/// (PartBins), which are better where queries are large and many boxes meet
/// them. Allocates nothing in the steady state.
class PartGrid {
 public:
  /// For boxes of which only what lies in `frame` matters. False, and nothing to
  /// be asked, if there are few boxes, or too many large ones, or if the frame has
  /// no length or no end.
  bool Build(std::span<const ImageBox> boxes, const ImageBox& frame) {
    if (boxes.size() < kFewest) return false;
    side_ = static_cast<std::size_t>(std::clamp(
        std::sqrt(static_cast<double>(boxes.size())), 1.0, kMostSide));
    x_.Start(frame.x_min(), frame.x_max(), side_);
    y_.Start(frame.y_min(), frame.y_max(), side_);
    if (!x_.IsProper() || !y_.IsProper()) return false;
    wide_.clear();
    ends_.assign(side_ * side_ + 1, 0);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Cells cells = CellsOf(boxes[i]);
      if (cells.size() > kMostCells) {
        wide_.push_back(static_cast<std::uint32_t>(i));
        if (wide_.size() * kWideShare > boxes.size()) return false;
      } else {
        ForEachCell(cells, [&](std::size_t cell) { ++ends_[cell]; });
      }
    }
    FillCells(boxes);
    return true;
  }

  /// Calls visit(index) -> bool for every box that may contain what of `box` is
  /// in the frame, as long as it returns true. Returns whether it always did.
  template <class Visit>
  bool ForEachAround(const ImageBox& box, Visit&& visit) const {
    const auto ask = [&](std::uint32_t i) { return visit(std::size_t{i}); };
    // It also has the corner.
    const std::size_t cell = y_.Bin(box.y_min()) * side_ + x_.Bin(box.x_min());
    return std::ranges::all_of(wide_, ask) &&
           std::ranges::all_of(EntriesOf(cell), ask);
  }

 private:
  /// With fewer boxes sets of bits (PartBins) are faster.
  static constexpr std::size_t kFewest = 1024;
  static constexpr double kMostSide = 256;
  /// A box in more cells than these is asked in every query; more than one box
  /// in kWideShare may not be.
  static constexpr std::size_t kMostCells = 32;
  static constexpr std::size_t kWideShare = 64;

  /// From the first to the last bin along both axes.
  struct Cells {
    std::array<std::size_t, 2> x;
    std::array<std::size_t, 2> y;

    [[nodiscard]] std::size_t size() const {
      return (x[1] - x[0] + 1) * (y[1] - y[0] + 1);
    }
  };

  [[nodiscard]] Cells CellsOf(const ImageBox& box) const {
    return {{x_.Bin(box.x_min()), x_.Bin(box.x_max())},
            {y_.Bin(box.y_min()), y_.Bin(box.y_max())}};
  }

  template <class Visit>
  void ForEachCell(const Cells& cells, const Visit& visit) const {
    for (std::size_t y = cells.y[0]; y <= cells.y[1]; ++y) {
      for (std::size_t x = cells.x[0]; x <= cells.x[1]; ++x)
        visit(y * side_ + x);
    }
  }

  /// From the numbers of the cells' boxes to the boxes themselves: of each cell
  /// in the order of their indices.
  void FillCells(std::span<const ImageBox> boxes) {
    std::uint32_t end = 0;
    for (std::uint32_t& entry : ends_) {
      const std::uint32_t count = entry;
      entry = end;  // for now where the cell begins
      end += count;
    }
    entries_.resize(end);
    std::size_t next_wide = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (next_wide < wide_.size() && wide_[next_wide] == i) {
        ++next_wide;
        continue;
      }
      ForEachCell(CellsOf(boxes[i]), [&](std::size_t cell) {
        entries_[ends_[cell]++] = static_cast<std::uint32_t>(i);
      });
    }
  }

  /// The boxes of a cell.
  [[nodiscard]] std::span<const std::uint32_t> EntriesOf(
      std::size_t cell) const {
    const std::size_t begin = cell == 0 ? 0 : ends_[cell - 1];
    return std::span(entries_).subspan(begin, ends_[cell] - begin);
  }

  std::size_t side_ = 1;  ///< cells along an axis
  BinAxis x_;
  BinAxis y_;
  std::vector<std::uint32_t> wide_;     ///< boxes in no cell, ascending
  std::vector<std::uint32_t> ends_;     ///< of the cells, in entries_
  std::vector<std::uint32_t> entries_;  ///< the boxes of cell after cell
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_PART_GRID_H_
