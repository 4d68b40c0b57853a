// SPDX-License-Identifier: GPL-3.0-or-later
// Levels for whoever names none.

#ifndef TRUELUX_ISOLUX_LEVEL_CHOICE_H_
#define TRUELUX_ISOLUX_LEVEL_CHOICE_H_

#include <vector>

namespace truelux {

/// So many levels with equal steps, the first and the last one half a step
/// within the range, each rounded to three digits (more if two would be the
/// same). Empty if the range is a point. 0 <= least <= most; count > 0.
std::vector<double> EvenLevels(double least, double most, int count);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LEVEL_CHOICE_H_
