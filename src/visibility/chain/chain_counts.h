// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_CHAIN_CHAIN_COUNTS_H_
#define TRUELUX_VISIBILITY_CHAIN_CHAIN_COUNTS_H_

#include <cstdint>

namespace truelux {

/// What chains have been made of, and where their depths came from.
struct ChainCounts {
  std::uint64_t sources = 0;     ///< that had a chain made
  std::uint64_t edges = 0;       ///< of these chains
  std::uint64_t several = 0;     ///< edges with a coefficient above 1
  std::uint64_t clipped = 0;     ///< edges cut by the source's plane
  std::uint64_t cuts = 0;        ///< edges where it cuts a piece
  std::uint64_t in_plane = 0;    ///< edges that lie in it
  std::uint64_t borders = 0;     ///< edges of what on_face takes away
  std::uint64_t diagonals = 0;   ///< intervals on a diagonal of the source
  std::uint64_t touching = 0;    ///< edges that touch the source's outline
  std::uint64_t overlaps = 0;    ///< of edges with others in one plane
  std::uint64_t queries = 0;     ///< depths that the tree was asked for
  std::uint64_t wide = 0;        ///< of them, those for which no ray was known
  std::uint64_t entered = 0;     ///< known where it crosses the source's edge
  std::uint64_t crossed = 0;     ///< known where it crosses another edge
  std::uint64_t propagated = 0;  ///< known from the edge before
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_CHAIN_COUNTS_H_
