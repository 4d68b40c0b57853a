// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_EDGES_BLOCK_SHARE_H_
#define TRUELUX_VISIBILITY_EDGES_BLOCK_SHARE_H_

#include <cstddef>
#include <optional>
#include <span>

#include "truelux/receiver.h"

#include "base/stamped_table.h"
#include "scene/index/box.h"
#include "scene/index/shaft.h"
#include "scene/index/triangle_tree.h"
#include "visibility/chain/shared_edges.h"
#include "visibility/edges/block_cut.h"
#include "visibility/edges/emitter_groups.h"

namespace truelux {

/// What a block of receivers shares on the way to each source. Keeps its memory
/// when it is used again.
class BlockShare {
 public:
  /// Starts with another block. Of less than two receivers nothing is shared.
  void Start(std::span<const Receiver> receivers, std::size_t emitter_count) {
    shares_ = receivers.size() > 1;
    if (!shares_) return;
    cuts_.Clear();
    cuts_.Cover(emitter_count);
    edges_.Clear();
    edges_.Cover(emitter_count);
    box_ = {};
    normal_ = receivers.front().normal;
    for (const Receiver& receiver : receivers) {
      box_.Include(receiver.position);
      if (receiver.normal != receivers.front().normal) normal_.reset();
    }
  }

  [[nodiscard]] bool shares() const { return shares_; }

  /// Contains the receivers.
  [[nodiscard]] const Box& box() const { return box_; }

  /// Holds the shafts of all receivers towards a source, as far as they are
  /// above the horizon.
  [[nodiscard]] Shaft ShaftTo(const ShaftSource& source) const {
    return {source, box_, normal_};
  }

  /// The parts of the tree on the way to an emitter, whose shafts are given.
  BlockCut& CutOf(EmitterId emitter, const TriangleTree& tree,
                  const ShaftSource& shafts) {
    if (!cuts_.Has(emitter)) cuts_.Renew(emitter).Start(tree, ShaftTo(shafts));
    return cuts_[emitter];
  }

  /// The edges on the way to an emitter, or to the group that begins with it.
  SharedEdges& EdgesOf(EmitterId emitter) {
    if (!edges_.Has(emitter)) edges_.Renew(emitter).Start();
    return edges_[emitter];
  }

 private:
  bool shares_ = false;
  Box box_;
  std::optional<Vector3> normal_;  ///< if all receivers share it
  StampedTable<BlockCut, EmitterId> cuts_;
  StampedTable<SharedEdges, EmitterId> edges_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_BLOCK_SHARE_H_
