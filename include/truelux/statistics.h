// How a result was reached: which stage answered how often.

#ifndef TRUELUX_STATISTICS_H_
#define TRUELUX_STATISTICS_H_

#include <cstdint>

namespace truelux {

/// Calls of one predicate, by the stage that answered.
struct StageCounts {
  std::uint64_t symbolic = 0;  ///< zero by construction, without arithmetic
  std::uint64_t filter = 0;    ///< double with an error bound
  std::uint64_t interval = 0;  ///< interval arithmetic
  std::uint64_t exact = 0;     ///< exact arithmetic

  StageCounts& operator+=(const StageCounts& other);
  friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

/// Counts are per receiver, and add up over receivers in any order.
struct Statistics {
  StageCounts receiver_side;  ///< r against the plane of a triangle
  StageCounts vertex_side;    ///< scene vertex against a source's plane
  StageCounts plane_side;     ///< direction against a plane through r
  StageCounts edge_order;     ///< two crossings along one edge

  std::uint64_t sources = 0;   ///< sources in front and above the horizon
  std::uint64_t blockers = 0;  ///< blocker parts, summed over sources, without
                               ///< those that others were found to hide
  std::uint64_t arcs = 0;      ///< arcs of the visible contours

  std::uint64_t evaluated_double = 0;          ///< receivers ended by double
  std::uint64_t evaluated_double_double = 0;   ///< .. by double-double
  std::uint64_t evaluated_multiprecision = 0;  ///< .. by Arb
  std::uint64_t evaluated_zero = 0;            ///< .. without any arc
  std::uint64_t ties = 0;                ///< channels decided by the tie rule
  std::uint64_t overflows = 0;           ///< channels too large for binary64
  std::uint64_t max_precision_bits = 0;  ///< largest precision used in Arb

  /// Adds counts; takes the larger max_precision_bits.
  Statistics& operator+=(const Statistics& other);
  friend bool operator==(const Statistics&, const Statistics&) = default;
};

}  // namespace truelux

#endif  // TRUELUX_STATISTICS_H_
