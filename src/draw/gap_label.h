// SPDX-License-Identifier: GPL-3.0-or-later
// A label in the gap of a line, and the gap.

#ifndef TRUELUX_DRAW_GAP_LABEL_H_
#define TRUELUX_DRAW_GAP_LABEL_H_

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "draw/paper_path.h"

namespace truelux {

/// A label: a rectangle that is turned about its middle.
struct GapLabel {
  PaperPoint middle;
  double angle = 0;  ///< of the text [degrees], clockwise, from -90 to 90
  double half_width = 0;
  double half_height = 0;
  std::size_t series = 0;  ///< which text

  [[nodiscard]] bool Overlaps(const GapLabel& other) const;
  [[nodiscard]] bool Holds(const PaperPoint& p) const;

  /// The point in the label's axes, from its middle.
  [[nodiscard]] PaperPoint PlaceOf(const PaperPoint& p) const;

  /// Its corners, in turn.
  [[nodiscard]] std::array<PaperPoint, 4> Corners() const;
};

/// What of a path is outside all labels.
std::vector<PaperPath> OutsideLabels(const PaperPath& path,
                                     std::span<const GapLabel> labels);

}  // namespace truelux

#endif  // TRUELUX_DRAW_GAP_LABEL_H_
