// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_CHAIN_SHARED_EDGES_H_
#define TRUELUX_VISIBILITY_CHAIN_SHARED_EDGES_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/index/box.h"
#include "scene/index/shaft.h"
#include "scene/index/silhouette_tree.h"

namespace truelux {

/// The edges that the chains of a block of receivers towards one source are
/// made of, found once for all of them if that pays. It changes no chain.
/// Keeps its memory when it is used again.
class SharedEdges {
 public:
  /// Starts with another block.
  void Start() {
    state_ = State::kNew;
    edges_.clear();
  }

  /// The edges for the next receiver of the block; null if they are not shared.
  /// make_shaft: returns a shaft around all receivers of the block, whose box is
  /// given; called once a block.
  template <class MakeShaft>
  const std::vector<SilhouetteEdge>* Get(const SilhouetteTree& tree,
                                         const MakeShaft& make_shaft,
                                         const Box& box) {
    if (state_ == State::kMeasured) {
      const Shaft shaft = make_shaft();
      const std::size_t most = kMostMore * alone_ + kLeastMost;
      const bool all = tree.Visit(shaft, box, [&](const SilhouetteEdge& edge) {
        edges_.push_back(edge);
        return edges_.size() <= most;
      });
      state_ = all ? State::kShared : State::kAlone;
    }
    return state_ == State::kShared ? &edges_ : nullptr;
  }

  /// How many edges the first receiver of the block looked at by itself.
  void Measure(std::size_t looked_at) {
    if (state_ != State::kNew) return;
    alone_ = looked_at;
    state_ = State::kMeasured;
  }

 private:
  /// To look at an edge of a list takes about half as long as to find it in the
  /// tree and look at it.
  static constexpr std::size_t kMostMore = 2;
  static constexpr std::size_t kLeastMost = 64;

  enum class State { kNew, kMeasured, kShared, kAlone };

  State state_ = State::kNew;
  std::size_t alone_ = 0;
  std::vector<SilhouetteEdge> edges_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_SHARED_EDGES_H_
