// SPDX-License-Identifier: GPL-3.0-or-later
// Where the formulas lose digits: families of random cases, each with one
// difficulty at a known size, to measure methods on.

#ifndef TRUELUX_BASELINES_REGIMES_H_
#define TRUELUX_BASELINES_REGIMES_H_

#include <vector>

#include "baselines/regime.h"

namespace truelux {

/// All of them, the unoccluded ones first, in order of growing difficulty
/// within a family.
[[nodiscard]] std::vector<Regime> Regimes();

}  // namespace truelux

#endif  // TRUELUX_BASELINES_REGIMES_H_
