// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in pictures.

#ifndef TRUELUX_DRAW_PAPER_PATH_H_
#define TRUELUX_DRAW_PAPER_PATH_H_

#include <vector>

namespace truelux {

/// A point of the picture [px], y downwards.
struct PaperPoint {
  double x = 0;
  double y = 0;
};

/// A polyline; a closed one ends where it begins.
using PaperPath = std::vector<PaperPoint>;

/// [px]
double LengthOf(const PaperPath& path);

}  // namespace truelux

#endif  // TRUELUX_DRAW_PAPER_PATH_H_
