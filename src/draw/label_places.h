// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels of lines go: into gaps of the lines, as on a map.

#ifndef TRUELUX_DRAW_LABEL_PLACES_H_
#define TRUELUX_DRAW_LABEL_PLACES_H_

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "draw/gap_label.h"
#include "draw/label_layout.h"
#include "draw/paper_path.h"

namespace truelux {

/// The size of the labels' font [px].
inline constexpr int kGapFont = 11;

/// A line that gets labels.
struct LabelledLine {
  PaperPath path;
  std::size_t series = 0;  ///< lines with one text
};

/// What labels should rather not cover, besides the lines.
struct Obstacle {
  PaperPath path;
  double weight = 1;  ///< 1: as bad as one of the lines
};

/// Places for labels, so that no two overlap and none leaves the frame: of each
/// series one on its longest line, where there is one; on lines that are long
/// more. texts: of the series. Where a line is too short or too bent, its label
/// stands beside it.
std::vector<GapLabel> PlaceGapLabels(std::span<const LabelledLine> lines,
                                     std::span<const std::string> texts,
                                     std::span<const Obstacle> obstacles,
                                     const LabelBox& frame);

}  // namespace truelux

#endif  // TRUELUX_DRAW_LABEL_PLACES_H_
