// SPDX-License-Identifier: GPL-3.0-or-later
// How predicates are decided.

#ifndef TRUELUX_EXACT_PREDICATE_KIND_H_
#define TRUELUX_EXACT_PREDICATE_KIND_H_

namespace truelux {

/// How predicates are decided.
enum class PredicateKind {
  kExact,       ///< in stages, always right
  kDisplaced,   ///< as kExact, and what is zero is decided at a displaced
                ///< receiver (exact/displacement.h)
  kUnfiltered,  ///< the sign of the double value, right or wrong: only to
                ///< measure what exactness costs
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_PREDICATE_KIND_H_
