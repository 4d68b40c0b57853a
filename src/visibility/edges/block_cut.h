// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_EDGES_BLOCK_CUT_H_
#define TRUELUX_VISIBILITY_EDGES_BLOCK_CUT_H_

#include <cstddef>

#include "scene/index/shaft.h"
#include "scene/index/triangle_tree.h"

namespace truelux {

/// What a block of receivers shares on the way to one source: the parts of the
/// tree that any of them needs, as long as that pays. Keeps its memory when it
/// is used again.
class BlockCut {
 public:
  /// Starts with another block. block: a shaft around all its receivers.
  void Start(const TriangleTree& tree, const Shaft& block) {
    tree.Narrow(block, cut_);
    is_useful_ = true;
  }

  /// TriangleTree::Visit for a receiver of the block.
  template <class Function>
  void Visit(const TriangleTree& tree, const Shaft& shaft,
             const Function& visit) {
    if (is_useful_) {
      const std::size_t kept = tree.Visit(shaft, cut_, visit);
      is_useful_ = kept * kLeastKept >= cut_.size();
    } else {
      tree.Visit(shaft, visit);
    }
  }

 private:
  /// A cut of which a receiver needs less than one part in so many makes the
  /// receiver look at more boxes than the tree would.
  static constexpr std::size_t kLeastKept = 4;

  TreeCut cut_;
  bool is_useful_ = true;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_BLOCK_CUT_H_
