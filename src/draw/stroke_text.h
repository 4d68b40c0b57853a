// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as lines, to be drawn at any size and angle.

#ifndef TRUELUX_DRAW_STROKE_TEXT_H_
#define TRUELUX_DRAW_STROKE_TEXT_H_

#include <string_view>
#include <vector>

#include "draw/paper_path.h"

namespace truelux {

/// The strokes of a number: digits and . - + e; others are left blank. Digits
/// are 1 high; the text begins at (0, 0), on its baseline, and goes to the
/// right; y downwards.
std::vector<PaperPath> TextStrokes(std::string_view text);

/// How wide the strokes are in all.
double StrokeTextWidth(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_DRAW_STROKE_TEXT_H_
