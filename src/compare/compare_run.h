// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene and a candidate to everything that a report says.

#ifndef TRUELUX_COMPARE_COMPARE_RUN_H_
#define TRUELUX_COMPARE_COMPARE_RUN_H_

#include <span>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "compare/candidate_errors.h"
#include "compare/candidate_report.h"
#include "compare/mistake_trial.h"
#include "run/watch.h"

namespace truelux {

/// How a candidate is compared.
struct CompareSettings {
  TruthOptions truth{};
  double tolerance = 0;  ///< the largest relative error that passes
  int threads = 1;
  Watch watch{};
};

/// The irradiances at some receivers, spread over threads. Throws Stopped.
[[nodiscard]] std::vector<Rgb> IrradiancesOf(
    const Oracle& oracle, std::span<const Receiver> receivers,
    const CompareSettings& settings);

/// Finds the truth, the errors, the worst receivers and, if a receiver fails,
/// the reason. scene: as it was read. data: without the truth, see
/// LoadCandidate. The names in the report are left empty. Throws Stopped.
[[nodiscard]] CandidateReport CompareCandidate(const Scene& scene,
                                               CandidateData data,
                                               const CompareSettings& settings);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_COMPARE_RUN_H_
