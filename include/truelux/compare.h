// SPDX-License-Identifier: GPL-3.0-or-later
// Another program's values beside the truth, and which mistake explains them:
// truelux compare for arrays. In the library truelux_tools.

#ifndef TRUELUX_COMPARE_H_
#define TRUELUX_COMPARE_H_

#include <cstddef>
#include <string>
#include <vector>

#include "truelux/comparison.h"
#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/gradient_comparison.h"
#include "truelux/irradiance.h"
#include "truelux/progress.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

namespace truelux {

/// Which channels another program computes, from 0, each once. Entries of other
/// channels are not looked at.
using ChannelNumbers = std::vector<std::size_t>;

/// What another program says of irradiances. Values may be nan or infinite:
/// these fail.
struct Candidate {
  std::vector<Receiver> receivers;
  std::vector<Rgb> values;  ///< E [W/m^2], one per receiver
  ChannelNumbers channels = {0, 1, 2};
  /// The values are form factors: E if every face that emits had M = 1, in
  /// entry 0. Channels do not count then.
  bool has_form_factors = false;
};

/// What another program says of dE/dr, the normal fixed (Derivatives).
struct GradientCandidate {
  std::vector<Receiver> receivers;
  std::vector<GradientRow> values;  ///< [W/m^3], one per receiver
  ChannelNumbers channels = {0, 1, 2};
};

/// How a candidate is compared, and who watches.
struct CompareOptions {
  /// The largest error that passes, relative to the truth; where that is 0, to
  /// the largest truth (docs/compare.md).
  double tolerance = 1e-6;
  Emission emission = Emission::kExitance;
  int threads = 1;                 ///< 1 .. 1024
  const StopFlag* stop = nullptr;  ///< asks the call to end with Stopped
  ProgressHook progress{};
  std::string scene_name = "scene";  ///< in the report
  std::string candidate_name = "values";
};

/// Finds the truth at every receiver, the errors and, if a receiver fails, the
/// reason. The result does not depend on threads.
///
/// Throws std::invalid_argument if there is no receiver, if there are not as
/// many values, or if an option is outside its range; ReceiverError for a
/// receiver that cannot be used; and Stopped.
[[nodiscard]] TRUELUX_EXPORT CandidateComparison
Compare(const Scene& scene, const Candidate& candidate,
        const CompareOptions& options);

/// The same of gradients. Throws as Compare does.
[[nodiscard]] TRUELUX_EXPORT GradientComparison
CompareGradients(const Scene& scene, const GradientCandidate& candidate,
                 const CompareOptions& options);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_H_
