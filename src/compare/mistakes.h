// SPDX-License-Identifier: GPL-3.0-or-later
// The classic mistakes of programs that compute irradiance, as one table.

#ifndef TRUELUX_COMPARE_MISTAKES_H_
#define TRUELUX_COMPARE_MISTAKES_H_

#include <span>
#include <string_view>
#include <vector>

#include "compare/mistake_trial.h"

namespace truelux {

/// A mistake by its name, and what it would make of a trial's receivers: one
/// hypothesis for each way to make it, none where it could not be told.
/// Whoever calls it fills in Hypothesis::mistake.
struct Mistake {
  std::string_view name;
  std::vector<Hypothesis> (*hypotheses)(MistakeTrial& trial);
};

/// All that are known. Where two explain a candidate equally, the first one is
/// named.
[[nodiscard]] std::span<const Mistake> Mistakes();

/// Objects and groups left out, one hypothesis for each and for each way: as a
/// source, as a blocker, or both. See mistakes_of_groups.cpp for how many.
[[nodiscard]] std::vector<Hypothesis> LeftOutGroups(MistakeTrial& trial);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_MISTAKES_H_
