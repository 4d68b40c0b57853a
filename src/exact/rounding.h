// SPDX-License-Identifier: GPL-3.0-or-later
// Asks how double arithmetic rounds, for the functions that require it.

#ifndef TRUELUX_EXACT_ROUNDING_H_
#define TRUELUX_EXACT_ROUNDING_H_

namespace truelux {

/// Whether double arithmetic of this thread rounds towards +infinity, as it
/// does while a RoundUpward object lives (exact/number.h). For assertions: the
/// compiler does not see through it.
bool IsRoundingUpward();

}  // namespace truelux

#endif  // TRUELUX_EXACT_ROUNDING_H_
