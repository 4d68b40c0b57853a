// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the triangles of a scene that meet a shaft or a ray, without looking at
// most of the others.

#ifndef TRUELUX_SCENE_INDEX_TRIANGLE_TREE_H_
#define TRUELUX_SCENE_INDEX_TRIANGLE_TREE_H_

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "exact/rounding.h"
#include "scene/index/box.h"
#include "scene/index/shaft.h"

namespace truelux {

/// The parts of a tree that a block of receivers needs. Keeps its memory when
/// it is used again.
class TreeCut {
 public:
  /// Whether nothing is left: no receiver of the block has a blocker.
  [[nodiscard]] bool empty() const { return parts_.empty(); }

  [[nodiscard]] std::size_t size() const { return parts_.size(); }

 private:
  friend class TriangleTree;

  /// A node: all that is below it, or only its triangles.
  struct Part {
    std::int32_t node;
    bool whole;
  };

  std::vector<Part> parts_;  ///< in visiting order
  std::vector<Part> next_;   ///< only while it is made
};

/// A bounding volume hierarchy whose nodes have up to four children, each a
/// node or a single triangle. Immutable; any number of threads may query it.
/// The same input makes the same tree.
class TriangleTree {
 public:
  TriangleTree() = default;  ///< no triangles

  /// Any finite coordinates, any number of triangles below 2^31. The tree
  /// keeps boxes and indices into `triangles`, but neither of its arguments.
  TriangleTree(std::span<const Point3> vertices,
               std::span<const Triangle> triangles);

  /// The same over any boxes: what is said of triangle i holds for box i.
  explicit TriangleTree(std::span<const Box> boxes);

  /// Calls visit(int triangle), once, for exactly the triangles whose box
  /// Shaft::Keeps, in an order that depends on the tree alone. (A node left
  /// out holds none of them: its box contains theirs, and the test is
  /// monotone.) Requires RoundUpward, which is in force in visit() too.
  ///
  /// Region: Shaft, or RayBoxes. visit() may make a region smaller meanwhile;
  /// triangles that only the larger one keeps may then be visited or not.
  template <class Region, class Function>
  void Visit(const Region& region, Function&& visit) const;

  /// The same, but only what is in the cut.
  ///
  /// The triangles visited are a subset of those of the full query, in the
  /// same order, and hold everything that meets the hull of a receiver of the
  /// cut's block and the source. But a triangle outside that hull may be
  /// visited or not, depending on the block: both shafts are a little wider
  /// than their hulls, and the block's may be the narrower one somewhere. So
  /// what is counted here must not go into results that have to be the same
  /// however receivers are grouped.
  ///
  /// Returns how many parts of the cut the shaft keeps something of: where these
  /// are few of all, the receiver does better without the cut.
  template <class Function>
  std::size_t Visit(const Shaft& shaft, const TreeCut& cut,
                    Function&& visit) const;

  /// Replaces the cut by parts of the tree that hold all triangles that the
  /// shaft of a block of receivers keeps. Requires RoundUpward.
  void Narrow(const Shaft& block, TreeCut& cut) const;

 private:
  friend class TriangleTreeBuilder;

  /// A child is ~triangle or, if positive, a node (never the root, 0); 0:
  /// none, and its box is empty.
  struct Node {
    FourBoxes boxes;
    std::array<std::int32_t, 4> children{};
    std::uint32_t leaves = 0;  ///< bit i: child i is a triangle
  };

  /// Levels of the tree, whatever the input.
  static constexpr std::size_t kMaxDepth = 80;

  template <class Region, class Function>
  void VisitBelow(const Region& region, std::int32_t index,
                  Function& visit) const;
  template <class Function>
  static void VisitTriangles(const Node& node, std::uint32_t kept,
                             Function& visit);
  void Refine(const Shaft& block, std::int32_t index,
              std::vector<TreeCut::Part>& parts) const;

  [[nodiscard]] const Node& At(std::int32_t node) const {
    return nodes_[static_cast<std::size_t>(node)];
  }

  std::vector<Node> nodes_;
};

template <class Region, class Function>
void TriangleTree::Visit(const Region& region, Function&& visit) const {
  assert(IsRoundingUpward());
  if (!nodes_.empty()) VisitBelow(region, 0, visit);
}

template <class Function>
std::size_t TriangleTree::Visit(const Shaft& shaft, const TreeCut& cut,
                                Function&& visit) const {
  assert(IsRoundingUpward());
  std::size_t kept_parts = 0;
  for (const TreeCut::Part& part : cut.parts_) {
    const Node& node = At(part.node);
    const std::uint32_t kept = shaft.Kept(node.boxes);
    if (kept == 0) continue;
    ++kept_parts;
    if (part.whole) {
      VisitBelow(shaft, part.node, visit);
    } else {
      VisitTriangles(node, kept, visit);
    }
  }
  return kept_parts;
}

/// Of a node, the triangles come before what is below its child nodes.
template <class Region, class Function>
void TriangleTree::VisitBelow(const Region& region, std::int32_t index,
                              Function& visit) const {
  // Not cleared: that would take as long as many a query.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  std::array<std::int32_t, 3 * kMaxDepth + 1> stack;
  std::size_t size = 0;
  stack[size++] = index;
  while (size > 0) {
    const Node& node = At(stack[--size]);
    const std::uint32_t kept = region.Kept(node.boxes);
    if (kept == 0) continue;
    for (std::size_t i = 4; i-- > 0;) {
      if (((kept & ~node.leaves) >> i & 1U) != 0) {
        stack[size++] = node.children[i];
      }
    }
    VisitTriangles(node, kept, visit);
  }
}

template <class Function>
void TriangleTree::VisitTriangles(const Node& node, std::uint32_t kept,
                                  Function& visit) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (((kept & node.leaves) >> i & 1U) != 0) visit(int{~node.children[i]});
  }
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_TRIANGLE_TREE_H_
