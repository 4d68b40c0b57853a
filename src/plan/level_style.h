// SPDX-License-Identifier: GPL-3.0-or-later
// How levels look and what they are called in a picture.

#ifndef TRUELUX_PLAN_LEVEL_STYLE_H_
#define TRUELUX_PLAN_LEVEL_STYLE_H_

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace truelux {

/// The colour of a level, from dark blue for the least to orange for the
/// largest: all dark enough for lines on white paper, and in order of lightness,
/// so that they stay apart without colours.
[[nodiscard]] std::string LevelColour(std::size_t level, std::size_t count);

/// The numbers on lines: the levels themselves, or, where they have many
/// digits, six of them, if that leaves them different.
[[nodiscard]] std::vector<std::string> LevelTexts(
    std::span<const double> levels);

}  // namespace truelux

#endif  // TRUELUX_PLAN_LEVEL_STYLE_H_
