// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_BASE_DISJOINT_SETS_H_
#define TRUELUX_BASE_DISJOINT_SETS_H_

#include <algorithm>
#include <cstddef>

#include "base/id_vector.h"

namespace truelux {

/// Disjoint sets of ids, each known by its least id. At first every id is a set
/// of its own.
template <class Key>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) {
    parents_.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
      parents_.push_back(parents_.end_id());
  }

  /// The least id of the set that an id is in.
  Key LeastOf(Key id) {
    while (parents_[id] != id) {
      Key& parent = parents_[id];
      parent = parents_[parent];
      id = parent;
    }
    return id;
  }

  /// Makes one set of those that two ids are in.
  void Join(Key a, Key b) {
    const Key first = LeastOf(a);
    const Key second = LeastOf(b);
    parents_[std::max(first, second)] = std::min(first, second);
  }

 private:
  IdVector<Key, Key> parents_;  ///< a set is a tree; its least id is the root
};

}  // namespace truelux

#endif  // TRUELUX_BASE_DISJOINT_SETS_H_
