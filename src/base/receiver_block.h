// SPDX-License-Identifier: GPL-3.0-or-later
// How many receivers are evaluated as one block.

#ifndef TRUELUX_BASE_RECEIVER_BLOCK_H_
#define TRUELUX_BASE_RECEIVER_BLOCK_H_

#include <cstddef>

namespace truelux {

/// The side of a block, where receivers lie in rows and columns (an image).
inline constexpr int kReceiverBlockSide = 4;

/// Consecutive receivers of one Oracle::Evaluate call that share what is found
/// out about where their blockers can be: per source, one narrowing of the
/// tree of blockers for all of them (docs/method.md, section 4).
///
/// Whoever divides receivers into several calls does so in shares of this
/// size, since a block never goes beyond a call. The larger a block, the fewer
/// narrowings; but the wider its receivers lie apart, the less a narrowing
/// leaves out, and threads, progress and Ctrl-C wait for whole shares. Results
/// do not depend on it; only the numbers of predicates do.
inline constexpr std::size_t kReceiverBlock =
    std::size_t{kReceiverBlockSide} * kReceiverBlockSide;

}  // namespace truelux

#endif  // TRUELUX_BASE_RECEIVER_BLOCK_H_
