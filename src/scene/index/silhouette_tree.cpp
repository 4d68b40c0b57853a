// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/silhouette_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/id_vector.h"
#include "exact/filter.h"
#include "exact/number.h"
#include "exact/recipe.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// A leaf has at most so many edges: what is known of a leaf costs as much as
/// asking a few edges.
constexpr std::size_t kMostInLeaf = 8;

/// An edge while the tree is built.
struct Item {
  EdgeId edge;
  Box box;

  /// Where it counts as being, at half scale so that nothing overflows.
  [[nodiscard]] double Centre(std::size_t axis) const {
    return 0.25 * box.lo[axis] + 0.25 * box.hi[axis];
  }
};

using Items = std::span<Item>;

/// Reorders the items so that each half is near itself; returns the half.
std::size_t Halve(Items items) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::ranges::minmax(
        items, {}, [axis](const Item& item) { return item.Centre(axis); });
    const double extent = hi.Centre(axis) - lo.Centre(axis);
    if (extent > most) {
      most = extent;
      widest = axis;
    }
  }
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(),
                   items.begin() + static_cast<std::ptrdiff_t>(half),
                   items.end(), [widest](const Item& a, const Item& b) {
                     return a.Centre(widest) < b.Centre(widest);
                   });
  return half;
}

/// The normal of a piece, times a power of two, with its bound.
ApproxVector ScaledNormal(const Scene& scene, const Piece& piece) {
  const std::array<VertexId, 3> corners =
      CornersOf(TrianglesOf(scene)[piece.triangle]);
  const auto vertices = VerticesOf(scene);
  const Point3& a = vertices[corners[0]];
  ApproxVector n = FilteredCross(FilteredDifference(a, vertices[corners[1]]),
                                 FilteredDifference(a, vertices[corners[2]]));
  const double size =
      std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  // A power of two, so that only what gets too small is rounded.
  if (!(n.error < size) || !(size > 0x1p-500) || !(size < 0x1p500)) {
    return {0, 0, 0, HUGE_VAL};
  }
  const double scale = std::ldexp(1.0, -std::ilogb(size));
  return {n.x * scale, n.y * scale, n.z * scale, n.error * scale};
}

}  // namespace

/// Top down, by halving.
class SilhouetteTreeBuilder {
 public:
  SilhouetteTreeBuilder(const Scene& scene, const ConvexPieces& pieces,
                        SilhouetteTree& tree)
      : vertices_(VerticesOf(scene)), pieces_(pieces), tree_(tree) {
    for (const Piece& piece : pieces.pieces())
      normals_.push_back(ScaledNormal(scene, piece));
  }

  void Build() {
    std::vector<Item> items;
    std::vector<Item> always;
    for (const EdgeId edge : EdgesOfPieces()) {
      if (pieces_.FirstSameEdge(edge) != edge) continue;
      Item item{edge, {}};
      item.box.Include(vertices_[pieces_.corners()[edge]]);
      item.box.Include(vertices_[pieces_.corners()[pieces_.NextCorner(edge)]]);
      (CanBeInner(edge) ? items : always).push_back(item);
    }
    if (items.empty() && always.empty()) return;
    tree_.inner_count_ = items.size();
    tree_.edges_.reserve(items.size() + always.size());
    // The two kinds stay apart, so that none makes the other be visited.
    const std::size_t root = AddNode();
    AddChild(root, items);
    AddChild(root, always);
    tree_.leaf_begins_.push_back(tree_.edges_.size());
  }

 private:
  [[nodiscard]] IdRange<EdgeId> EdgesOfPieces() const {
    return pieces_.corners().ids();
  }

  /// Whether an edge is inner if its pieces show r the same side.
  [[nodiscard]] bool CanBeInner(EdgeId edge) const {
    const EdgeId other = pieces_.NextSameEdge(edge);
    return other != edge && pieces_.NextSameEdge(other) == edge &&
           pieces_.corners()[other] != pieces_.corners()[edge] &&
           IsKnown(edge) && IsKnown(other);
  }

  /// Whether something is known of the normal.
  [[nodiscard]] bool IsKnown(EdgeId edge) const {
    return normals_[pieces_.PieceOf(edge)].error < HUGE_VAL;
  }

  [[nodiscard]] SilhouetteEdge RecordOf(EdgeId edge) const {
    return {edge, pieces_.PieceOf(edge),
            CanBeInner(edge) ? pieces_.PieceOf(pieces_.NextSameEdge(edge))
                             : PieceId()};
  }

  std::size_t AddNode() {
    tree_.nodes_.emplace_back();
    return tree_.nodes_.size() - 1;
  }

  SilhouetteTree::Node& At(std::size_t node) { return tree_.nodes_[node]; }

  /// Adds a set of items, of one kind, below a node.
  void AddChild(std::size_t node, Items items) {
    if (items.empty()) return;
    SetBounds(At(node), At(node).count, items);
    std::int32_t child = 0;
    if (items.size() <= kMostInLeaf) {
      child = ~static_cast<std::int32_t>(tree_.leaf_begins_.size());
      tree_.leaf_begins_.push_back(tree_.edges_.size());
      for (const Item& item : items)
        tree_.edges_.push_back(RecordOf(item.edge));
    } else {
      const std::size_t below = AddNode();
      child = static_cast<std::int32_t>(below);
      const std::size_t half = Halve(items);
      for (const Items part : {items.first(half), items.subspan(half)}) {
        const std::size_t quarter = Halve(part);
        AddChild(below, part.first(quarter));
        AddChild(below, part.subspan(quarter));
      }
    }
    At(node).children[At(node).count] = child;
    ++At(node).count;
  }

  void SetBounds(SilhouetteTree::Node& node, std::size_t lane, Items items) {
    Box box;
    for (const Item& item : items)
      box.Include(item.box);
    node.boxes.Set(lane, box);
    std::array<double, 3> centre{};
    for (std::size_t k = 0; k < 3; ++k)
      centre[k] = 0.5 * box.lo[k] + 0.5 * box.hi[k];
    Bounds bounds;
    if (CanBeInner(items.front().edge)) {
      bounds = {{HUGE_VAL, HUGE_VAL, HUGE_VAL},
                {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL},
                HUGE_VAL,
                -HUGE_VAL};
      for (const Item& item : items) {
        Include(item.edge, centre, bounds);
        Include(pieces_.NextSameEdge(item.edge), centre, bounds);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      node.centre[k][lane] = centre[k];
      node.least_normal[k][lane] = bounds.least_normal[k];
      node.most_normal[k][lane] = bounds.most_normal[k];
    }
    node.least_offset[lane] = bounds.least_offset;
    node.most_offset[lane] = bounds.most_offset;
  }

  /// By default of what must always be visited.
  struct Bounds {
    std::array<double, 3> least_normal{};
    std::array<double, 3> most_normal{};
    double least_offset = -1;
    double most_offset = 1;
  };

  void Include(EdgeId edge, const std::array<double, 3>& centre,
               Bounds& bounds) const {
    const ApproxVector& normal = normals_[pieces_.PieceOf(edge)];
    const std::array<double, 3> n{normal.x, normal.y, normal.z};
    const Point3& point = vertices_[pieces_.corners()[edge]];
    const std::array<double, 3> t{point.x, point.y, point.z};
    double most = 0;
    double minus_least = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double n_most = n[k] + normal.error;
      const double n_least = -(normal.error - n[k]);
      const double d_most = t[k] - centre[k];
      const double d_least = -(centre[k] - t[k]);
      bounds.least_normal[k] = std::min(bounds.least_normal[k], n_least);
      bounds.most_normal[k] = std::max(bounds.most_normal[k], n_most);
      most += std::max({n_least * d_least, n_least * d_most, n_most * d_least,
                        n_most * d_most});
      minus_least += std::max({-n_least * d_least, -n_least * d_most,
                               -n_most * d_least, -n_most * d_most});
    }
    bounds.most_offset = std::max(bounds.most_offset, most);
    bounds.least_offset = std::min(bounds.least_offset, -minus_least);
  }

  IdSpan<VertexId, const Point3> vertices_;
  const ConvexPieces& pieces_;
  SilhouetteTree& tree_;
  IdVector<PieceId, ApproxVector> normals_;
};

SilhouetteTree::SilhouetteTree(const Scene& scene, const ConvexPieces& pieces) {
  const RoundUpward rounding;
  SilhouetteTreeBuilder(scene, pieces, *this).Build();
  nodes_.shrink_to_fit();
  leaf_begins_.shrink_to_fit();
}

bool SilhouetteTree::HasNear(const Shaft& shaft, std::size_t count) const {
  assert(count > 0);
  if (inner_count_ < count) return false;
  // The first child of the root holds them all, as a node or a leaf.
  std::array<std::int32_t, 3 * kMaxDepth + 1> stack{nodes_.front().children[0]};
  std::size_t size = 1;
  std::size_t near = 0;
  while (size > 0) {
    const std::int32_t index = stack[--size];
    if (index < 0) {
      near += EdgesOf(~index).size();
      if (near >= count) return true;
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    const std::uint32_t kept = shaft.Kept(node.boxes);
    for (std::size_t i = 0; i < node.count; ++i) {
      if ((kept >> i & 1U) != 0) stack[size++] = node.children[i];
    }
  }
  return false;
}

/// h = N . (t - r) = N . (t - c) + N . (c - r) is within the bounds' sum. Where
/// a difference overflows nothing is known: it would be 0 times infinity.
std::uint32_t SilhouetteTree::Undecided(const Node& node,
                                        const Box& receivers) {
  Lanes most;         // at least h
  Lanes minus_least;  // at least -h
  Load(node.most_offset, most);
  Load(node.least_offset, minus_least);
  minus_least = -minus_least;
  LaneFlags finite = ~LaneFlags{};
  for (std::size_t k = 0; k < 3; ++k) {
    Lanes centre;
    Lanes n_least;
    Lanes n_most;
    Load(node.centre[k], centre);
    Load(node.least_normal[k], n_least);
    Load(node.most_normal[k], n_most);
    const Lanes d_most = centre - receivers.lo[k];
    const Lanes d_least = -(receivers.hi[k] - centre);
    finite &= (d_most < HUGE_VAL) & (d_least > -HUGE_VAL);
    const auto greater = [](const Lanes& a, const Lanes& b) -> Lanes {
      return a > b ? a : b;
    };
    most += greater(greater(n_least * d_least, n_least * d_most),
                    greater(n_most * d_least, n_most * d_most));
    minus_least += greater(greater(-n_least * d_least, -n_least * d_most),
                           greater(-n_most * d_least, -n_most * d_most));
  }
  const LaneFlags decided = finite & ((most < 0.0) | (minus_least < 0.0));
  return ~Gather(decided) & ((1U << kLanes) - 1);
}

}  // namespace truelux
