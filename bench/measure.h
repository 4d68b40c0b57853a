// SPDX-License-Identifier: GPL-3.0-or-later
// Timing of several methods side by side.

#ifndef TRUELUX_BENCH_MEASURE_H_
#define TRUELUX_BENCH_MEASURE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/statistics.h"

#include "methods.h"
#include "scenes.h"
#include "text/quantile.h"

namespace truelux::bench {

/// What a method costs on a scene, and how far off it is.
struct Measurement {
  std::string scene;
  std::string method;
  std::string family;
  int receivers = 0;
  std::vector<double> rounds;  ///< microseconds a receiver, one per round
  /// Root of the mean of ((value - certified) / certified)^2 over the receivers
  /// whose certified value is not 0; nothing if there are none. For the
  /// certified values themselves the same of their bounds.
  std::optional<double> error;
  Statistics statistics;  ///< over all receivers

  [[nodiscard]] double Microseconds() const { return Median(rounds); }
};

/// A scene and what is to be run on it.
struct Task {
  const BenchScene* scene = nullptr;
  std::vector<Contender> methods;  ///< the certified one first
};

struct Limits {
  int rounds = 1;      ///< so many at most, and one at least
  double seconds = 0;  ///< no further round starts after these
};

/// Runs everything once untimed, for the values, and then in rounds, each
/// method once a round in one thread, so that what else the machine does meets
/// all methods alike.
std::vector<Measurement> Measure(const std::vector<Task>& tasks,
                                 const Limits& limits);

/// The measurement with these names; null if there is none.
const Measurement* Find(const std::vector<Measurement>& measurements,
                        std::string_view scene, std::string_view method);

/// a's time by b's: the median over rounds if they were measured together,
/// else the ratio of the medians.
[[nodiscard]] double Ratio(const Measurement& a, const Measurement& b);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_MEASURE_H_
