// SPDX-License-Identifier: GPL-3.0-or-later
// Runs many methods on the receivers of one scene.

#ifndef TRUELUX_STUDY_BENCH_RUN_H_
#define TRUELUX_STUDY_BENCH_RUN_H_

#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "study/bench_methods.h"
#include "study/comparison.h"

namespace truelux {

/// How long the methods may take.
struct BenchLimits {
  /// Processor time per method [s]. When it is used up no further receivers
  /// are tried, in an order that leaves them spread over the table, and no
  /// further rounds. A method that is not done with its first receivers after
  /// that time, or a second if that is longer, is left out. The truth is found
  /// whole.
  double seconds = 10;
  int rounds = 5;  ///< of timing, in which the methods take turns
};

/// Values, times and errors of all methods, in one thread. receivers: not
/// empty; methods: at least one, the first gives the truth. Throws
/// Stopped. The name of the scene is left empty.
Comparison RunMethods(const Scene& scene, std::vector<Receiver> receivers,
                      const MethodList& list, const BenchLimits& limits);

}  // namespace truelux

#endif  // TRUELUX_STUDY_BENCH_RUN_H_
