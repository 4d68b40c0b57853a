// SPDX-License-Identifier: GPL-3.0-or-later
// How a result was reached: which stage answered how often.

#ifndef TRUELUX_STATISTICS_H_
#define TRUELUX_STATISTICS_H_

#include <cstdint>

#include "truelux/export.h"

namespace truelux {

/// Calls of one predicate, by the stage that gave its sign. Every sign is
/// right, whichever stage gave it; a later stage is asked only where the one
/// before it cannot tell.
struct TRUELUX_EXPORT StageCounts {
  std::uint64_t symbolic = 0;  ///< zero by construction, without arithmetic
  std::uint64_t filter = 0;    ///< double with an error bound
  std::uint64_t interval = 0;  ///< interval arithmetic
  std::uint64_t double_double = 0;  ///< double-double with an error bound
  std::uint64_t exact = 0;          ///< exact arithmetic

  /// Adds the counts of another.
  StageCounts& operator+=(const StageCounts& other);
  friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

/// What the answer for one receiver cost. Statistics of several receivers add
/// up, in any order. The four predicates and `blockers` are counted by
/// Engine::kContour only; r is the receiver's position.
struct TRUELUX_EXPORT Statistics {
  StageCounts receiver_side;  ///< r against the plane of a triangle
  StageCounts vertex_side;    ///< a scene vertex against a source's plane
  StageCounts plane_side;     ///< a direction against a plane through r
  StageCounts edge_order;     ///< two crossings along one edge

  /// Sources in front and above the horizon. Emitters of one plane that emit the
  /// same count as one where only the sum over all sources was asked for.
  std::uint64_t sources = 0;
  /// Blocker parts, summed over sources, without those that others were found to
  /// hide; none of sources that went by the chain (docs/method.md, section 11).
  std::uint64_t blockers = 0;
  std::uint64_t arcs = 0;  ///< arcs of the visible contours

  // How many evaluations ended in which arithmetic. One receiver is one
  // evaluation, except that Oracle::FormFactors makes one for each face.
  std::uint64_t evaluated_double = 0;          ///< in double
  std::uint64_t evaluated_double_double = 0;   ///< in double-double
  std::uint64_t evaluated_multiprecision = 0;  ///< in Arb
  std::uint64_t evaluated_zero = 0;            ///< without any arc: E = 0
  std::uint64_t ties = 0;                ///< channels decided by the tie rule
  std::uint64_t overflows = 0;           ///< channels too large for binary64
  std::uint64_t max_precision_bits = 0;  ///< largest precision in Arb [bit]

  /// Adds the counts of another; takes the larger max_precision_bits.
  Statistics& operator+=(const Statistics& other);
  friend bool operator==(const Statistics&, const Statistics&) = default;
};

}  // namespace truelux

#endif  // TRUELUX_STATISTICS_H_
