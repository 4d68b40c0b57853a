// SPDX-License-Identifier: GPL-3.0-or-later
// The contours of a floor, followed by the published tracer from one vertex of
// each contour of truelux. Starting points are a gift: finding them all is most
// of the work.

#ifndef TRUELUX_BENCH_TRACED_CONTOURS_H_
#define TRUELUX_BENCH_TRACED_CONTOURS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "contour_distances.h"
#include "predictor_tracer.h"

namespace truelux::bench {

/// What came of it.
struct TracedContours {
  std::vector<DrawnContour> contours;  ///< one of each contour of truelux
  /// Those that closed, or came within 2 h of both ends of truelux's, after
  /// about the same length.
  std::size_t completed = 0;
  /// How the other contours' traces ended, by TraceEnd; an open contour has two
  /// traces, to both sides. A trace that went on along another contour may have
  /// any end.
  std::array<std::size_t, 5> failed_ends{};
  std::size_t points = 0;
  std::uint64_t evaluations = 0;
  SortedNumbers misses;  ///< of the predictor, by h
  /// How often a step went across a line on which the gradient jumps.
  std::size_t kinks = 0;
  /// And a predictor that had points on both sides missed by more than kLargeMiss.
  std::size_t missed_kinks = 0;
  std::size_t large_misses = 0;  ///< likewise, anywhere
};

/// The step with which as many points as truelux's contours have would do: the
/// mean length of their chords [length].
[[nodiscard]] double MeanChord(const Isolux& isolux);

/// Follows all contours of the floor "floor" in the first channel, to within
/// 1e-9 of the range of E. isolux: the floor's contours in that channel. options:
/// what is the same for all of them, that is predictor, step and is_restarting.
[[nodiscard]] TracedContours TraceContours(const Oracle& oracle,
                                           const Isolux& isolux,
                                           const TraceOptions& options);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_TRACED_CONTOURS_H_
