// SPDX-License-Identifier: GPL-3.0-or-later
// Where methods are farthest from the truth.

#ifndef TRUELUX_STUDY_WORST_RECEIVERS_H_
#define TRUELUX_STUDY_WORST_RECEIVERS_H_

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "study/comparison.h"
#include "study/comparison_summary.h"

namespace truelux {

/// A receiver, and how the methods of one group do there.
struct WorstReceiver {
  std::size_t receiver = 0;  ///< index into Comparison::receivers
  std::size_t method = 0;    ///< the worst one of the group here
  ValueError error;          ///< of it
  std::size_t best_method = 0;
  ValueError best_error;
};

struct WorstOfGroup {
  std::string group;
  std::size_t wrong = 0;  ///< receivers at which some method is not exact
  std::vector<WorstReceiver> worst;  ///< the largest errors first
};

/// How bad an error is, to rank by: the relative one; infinite for light where
/// there is none.
[[nodiscard]] double RankOf(const ValueError& error);

/// Per group the `most` receivers at which some method of the group has the
/// largest error, with that method and the best one; receivers at which all
/// are exact are left out. Of equal errors the first receivers.
[[nodiscard]] std::vector<WorstOfGroup> WorstReceivers(
    const Comparison& comparison, std::size_t most = 10);

/// The receivers of all groups, each once; those that are first in their
/// groups come first.
[[nodiscard]] std::vector<std::size_t> ReceiversOf(
    std::span<const WorstOfGroup> groups);

}  // namespace truelux

#endif  // TRUELUX_STUDY_WORST_RECEIVERS_H_
