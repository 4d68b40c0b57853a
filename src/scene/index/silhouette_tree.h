// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_SCENE_INDEX_SILHOUETTE_TREE_H_
#define TRUELUX_SCENE_INDEX_SILHOUETTE_TREE_H_

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "truelux/scene.h"

#include "base/ids.h"
#include "exact/lanes.h"
#include "exact/rounding.h"
#include "scene/index/box.h"
#include "scene/index/convex_pieces.h"
#include "scene/index/shaft.h"

namespace truelux {

/// An edge that may be a silhouette or a border: of the edges between its
/// vertices the first.
struct SilhouetteEdge {
  EdgeId edge;
  PieceId piece;
  /// The only other piece, which runs through the edge in the opposite
  /// direction; none if the edge cannot be inner.
  PieceId other_piece;
};

/// Finds the edges of a scene's pieces that may be silhouettes or borders. An
/// edge is inner, seen from r, if exactly two pieces have it, run through it in
/// opposite directions, and both show r the same side. Whole subtrees of inner
/// edges are left out: those where N . (t - r) has one sign for all normals N
/// and planes of a bound (method.md, section 11). Immutable; any number of
/// threads may ask it. The same scene makes the same tree.
class SilhouetteTree {
 public:
  SilhouetteTree() = default;  ///< no edges

  /// What the arguments refer to need not live on.
  SilhouetteTree(const Scene& scene, const ConvexPieces& pieces);

  /// Calls visit(SilhouetteEdge) -> bool, once, for edges near the shaft, among
  /// them all that meet it and are not inner for some receiver in the box
  /// `receivers`, as long as it returns true. Returns whether it always did.
  /// The order depends on the tree alone. Requires RoundUpward.
  template <class Function>
  bool Visit(const Shaft& shaft, const Box& receivers, Function&& visit) const;

  /// Whether at least `count` edges, 1 or more, that can be inner are near the
  /// shaft: in leaves that meet it. Costs less the sooner the answer is known.
  /// The answer depends on the tree and the shaft alone. Requires RoundUpward.
  [[nodiscard]] bool HasNear(const Shaft& shaft, std::size_t count) const;

 private:
  friend class SilhouetteTreeBuilder;

  /// Bounds on the pieces at the edges of each child: of their normals N,
  /// scaled by powers of two, and of N . (t - c), t a point of the piece's
  /// plane and c a centre that is given. Of a child that must always be
  /// visited, zero normals and bounds of both signs.
  struct Node {
    FourBoxes boxes;
    std::array<LaneArray, 3> centre{};
    std::array<LaneArray, 3> least_normal{};
    std::array<LaneArray, 3> most_normal{};
    LaneArray least_offset{};
    LaneArray most_offset{};
    std::array<std::int32_t, 4> children{};  ///< ~leaf, or a node
    std::uint32_t count = 0;                 ///< of children
  };

  /// The children that a receiver in the box may not have on one side.
  static std::uint32_t Undecided(const Node& node, const Box& receivers);

  [[nodiscard]] std::span<const SilhouetteEdge> EdgesOf(
      std::int32_t leaf) const {
    const auto i = static_cast<std::size_t>(leaf);
    return std::span(edges_).subspan(leaf_begins_[i],
                                     leaf_begins_[i + 1] - leaf_begins_[i]);
  }

  /// Sets are halved twice a level, below 2^31 of them.
  static constexpr std::size_t kMaxDepth = 20;

  std::vector<Node> nodes_;
  std::vector<std::size_t> leaf_begins_;  ///< in edges_; and the last end
  std::vector<SilhouetteEdge> edges_;
  std::size_t inner_count_ = 0;  ///< of the edges that can be inner
};

template <class Function>
bool SilhouetteTree::Visit(const Shaft& shaft, const Box& receivers,
                           Function&& visit) const {
  assert(IsRoundingUpward());
  if (nodes_.empty()) return true;
  // Not cleared: that would take as long as many a query.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  std::array<std::int32_t, 3 * kMaxDepth + 1> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--size])];
    std::uint32_t kept = shaft.Kept(node.boxes);
    if (kept != 0) kept &= Undecided(node, receivers);
    for (std::size_t i = 0; i < node.count; ++i) {
      if ((kept >> i & 1U) == 0) continue;
      const std::int32_t child = node.children[i];
      if (child >= 0) {
        stack[size++] = child;
      } else {
        for (const SilhouetteEdge& edge : EdgesOf(~child)) {
          if (!visit(edge)) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_SILHOUETTE_TREE_H_
