// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/triangle_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/rounding.h"

namespace truelux {
namespace {

/// A triangle while the tree is built.
struct Item {
  Box box;
  std::int32_t triangle = 0;

  /// Where it counts as being, at half scale so that nothing overflows.
  [[nodiscard]] double Centre(std::size_t axis) const {
    return 0.25 * box.lo[axis] + 0.25 * box.hi[axis];
  }
};

using Items = std::span<Item>;

// Splits that follow the surface area may take off one triangle at a time
// from vertices whose distances grow like powers; from this level on, sets are
// halved instead.
constexpr std::size_t kMaxAreaLevels = 48;

constexpr std::size_t kBinCount = 16;

// A cut is not made finer than this: where a block keeps much, each of its
// receivers does better to find its way down the tree than to try all parts.
constexpr std::size_t kEnoughParts = 256;

/// A number of bins along one axis.
struct Binning {
  std::size_t axis = 0;
  double origin = 0;
  double scale = 0;  ///< bins per length; 0: all centres are the same

  [[nodiscard]] std::size_t BinOf(const Item& item) const {
    const double x = (item.Centre(axis) - origin) * scale;
    return std::min(kBinCount - 1, static_cast<std::size_t>(x));
  }
};

/// Across the widest extent of the centres.
Binning BinsOf(Items items) {
  Binning binning;
  double widest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    for (const Item& item : items) {
      least = std::min(least, item.Centre(axis));
      most = std::max(most, item.Centre(axis));
    }
    if (most - least <= widest) continue;
    widest = most - least;
    // For widths whose reciprocal overflows, the bins are wider than need be.
    binning = {
        axis, least,
        std::min(kBinCount / widest, std::numeric_limits<double>::max())};
  }
  return binning;
}

/// Half the surface of a box, in units of a box around it. Extents are taken
/// at half scale so that they do not overflow.
class AreaMeasure {
 public:
  explicit AreaMeasure(const Box& whole) {
    double widest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      widest = std::max(widest, 0.5 * whole.hi[k] - 0.5 * whole.lo[k]);
    scale_ = std::min(1 / widest, std::numeric_limits<double>::max());
  }

  [[nodiscard]] double Of(const Box& box) const {
    const auto extent = [&](std::size_t k) {
      return (0.5 * box.hi[k] - 0.5 * box.lo[k]) * scale_;
    };
    const double x = extent(0);
    const double y = extent(1);
    const double z = extent(2);
    return x * y + y * z + z * x;
  }

 private:
  double scale_ = 0;
};

Box BoxOf(Items items) {
  Box box;
  for (const Item& item : items)
    box.Include(item.box);
  return box;
}

std::vector<Box> BoxesOf(std::span<const Point3> vertices,
                         std::span<const Triangle> triangles) {
  const IdSpan<VertexId, const Point3> places(vertices);
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const int vertex : triangles[i].vertices)
      boxes[i].Include(places[VertexId(vertex)]);
  }
  return boxes;
}

}  // namespace

/// Top down: a node's items are split in two until there are four sets.
class TriangleTreeBuilder {
 public:
  explicit TriangleTreeBuilder(std::vector<TriangleTree::Node>& nodes)
      : nodes_(nodes) {}

  /// items: at least one. Nodes come in depth-first order.
  std::int32_t Build(Items items, std::size_t level) {
    const auto index = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    Set sets[4];
    const std::size_t count = Divide(items, level, sets);
    for (std::size_t i = 0; i < count; ++i) {
      const bool leaf = sets[i].items.size() == 1;
      const std::int32_t child =
          leaf ? ~sets[i].items[0].triangle : Build(sets[i].items, level + 1);
      TriangleTree::Node& node = nodes_[static_cast<std::size_t>(index)];
      node.boxes.Set(i, sets[i].box);
      node.children[i] = child;
      node.leaves |= (leaf ? 1U : 0U) << i;
    }
    return index;
  }

 private:
  struct Set {
    Items items;
    Box box;
  };

  struct Bin {
    Box box;
    std::size_t count = 0;
  };

  /// Up to four sets, none empty, in an order that keeps neighbours together.
  static std::size_t Divide(Items items, std::size_t level, Set (&sets)[4]) {
    if (items.size() <= 4) {
      for (std::size_t i = 0; i < items.size(); ++i)
        sets[i] = {items.subspan(i, 1), items[i].box};
      return items.size();
    }
    std::size_t count = 1;
    sets[0] = {items, BoxOf(items)};
    const AreaMeasure area(sets[0].box);
    while (count < 4) {
      std::size_t next = 4;
      double largest = -1;
      for (std::size_t i = 0; i < count; ++i) {
        if (count > 1 && sets[i].items.size() <= 4) continue;
        const double size = level < kMaxAreaLevels
                                ? area.Of(sets[i].box)
                                : static_cast<double>(sets[i].items.size());
        if (size > largest) {
          largest = size;
          next = i;
        }
      }
      if (next == 4) break;
      const Set set = sets[next];
      const std::size_t middle = Split(set.items, level, area);
      for (std::size_t i = count; i > next + 1; --i)
        sets[i] = sets[i - 1];
      const Items first = set.items.first(middle);
      const Items second = set.items.subspan(middle);
      sets[next] = {first, BoxOf(first)};
      sets[next + 1] = {second, BoxOf(second)};
      ++count;
    }
    return count;
  }

  /// Reorders the items and returns how many come first; neither part is
  /// empty.
  static std::size_t Split(Items items, std::size_t level,
                           const AreaMeasure& area) {
    const Binning binning = BinsOf(items);
    if (level >= kMaxAreaLevels || binning.scale == 0) return items.size() / 2;
    std::array<Bin, kBinCount> bins;
    for (const Item& item : items) {
      Bin& bin = bins[binning.BinOf(item)];
      bin.box.Include(item.box);
      ++bin.count;
    }
    const std::size_t border = BestBorder(bins, area);
    const auto middle = std::partition(
        items.begin(), items.end(),
        [&](const Item& item) { return binning.BinOf(item) < border; });
    const auto first = static_cast<std::size_t>(middle - items.begin());
    // All in one bin: only where the reciprocal of the width overflowed.
    return first == 0 || first == items.size() ? items.size() / 2 : first;
  }

  /// The bin before which a split costs least: the sum of area times number
  /// of nodes on both sides.
  static std::size_t BestBorder(const std::array<Bin, kBinCount>& bins,
                                const AreaMeasure& area) {
    const auto cost = [&area](const Bin& bin) {
      const std::size_t nodes = (bin.count + 3) / 4;
      return area.Of(bin.box) * static_cast<double>(nodes);
    };
    std::array<double, kBinCount> above{};
    Bin sum;
    for (std::size_t i = kBinCount; i-- > 1;) {
      sum.box.Include(bins[i].box);
      sum.count += bins[i].count;
      above[i] = sum.count > 0 ? cost(sum) : HUGE_VAL;
    }
    std::size_t best = kBinCount / 2;
    double least = HUGE_VAL;
    sum = {};
    for (std::size_t i = 1; i < kBinCount; ++i) {
      sum.box.Include(bins[i - 1].box);
      sum.count += bins[i - 1].count;
      if (sum.count == 0) continue;
      const double total = cost(sum) + above[i];
      if (total < least) {
        least = total;
        best = i;
      }
    }
    return best;
  }

  std::vector<TriangleTree::Node>& nodes_;
};

TriangleTree::TriangleTree(std::span<const Box> boxes) {
  if (boxes.empty()) return;
  std::vector<Item> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    items[i] = {boxes[i], static_cast<std::int32_t>(i)};
  nodes_.reserve(boxes.size() / 2);
  TriangleTreeBuilder(nodes_).Build(items, 0);
  nodes_.shrink_to_fit();
}

TriangleTree::TriangleTree(std::span<const Point3> vertices,
                           std::span<const Triangle> triangles)
    : TriangleTree(BoxesOf(vertices, triangles)) {}

void TriangleTree::Narrow(const Shaft& block, TreeCut& cut) const {
  assert(IsRoundingUpward());
  cut.parts_.clear();
  if (!nodes_.empty()) cut.parts_.push_back({0, true});
  // Level by level. Parts in the place of their node keep the order of a
  // visit: the node's own triangles, then its child nodes.
  bool refined = true;
  while (refined && cut.parts_.size() < kEnoughParts) {
    refined = false;
    cut.next_.clear();
    for (const TreeCut::Part& part : cut.parts_) {
      if (part.whole) {
        Refine(block, part.node, cut.next_);
        refined = true;
      } else {
        cut.next_.push_back(part);
      }
    }
    cut.parts_.swap(cut.next_);
  }
}

/// Appends what the shaft keeps of a node's children.
void TriangleTree::Refine(const Shaft& block, std::int32_t index,
                          std::vector<TreeCut::Part>& parts) const {
  const Node& node = At(index);
  const std::uint32_t kept = block.Kept(node.boxes);
  if ((kept & node.leaves) != 0) parts.push_back({index, false});
  for (std::size_t i = 0; i < 4; ++i) {
    if (((kept & ~node.leaves) >> i & 1U) != 0)
      parts.push_back({node.children[i], true});
  }
}

}  // namespace truelux
