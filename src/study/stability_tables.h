// SPDX-License-Identifier: GPL-3.0-or-later
// The measurements of truelux stability as tables.

#ifndef TRUELUX_STUDY_STABILITY_TABLES_H_
#define TRUELUX_STUDY_STABILITY_TABLES_H_

#include <string>
#include <vector>

#include "baselines/stability_study.h"

namespace truelux {

/// For each arithmetic a table of regimes by formulas; a table of times; whether
/// the bounds hold.
std::string StabilityMarkdown(const StabilityOptions& options,
                              const std::vector<RegimeStability>& results);

/// One line for each regime, arithmetic and formula that applies to some case.
std::string StabilityCsv(const std::vector<RegimeStability>& results);

}  // namespace truelux

#endif  // TRUELUX_STUDY_STABILITY_TABLES_H_
