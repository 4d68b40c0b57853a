// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/view_loops.h"

#include <algorithm>
#include <cstddef>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// Half-arc 2 a runs through arc a as it is, 2 a + 1 the other way.
constexpr int Twin(int half) {
  return half ^ 1;
}

class LoopTracer {
 public:
  LoopTracer(const GluedView& view, std::span<const Vec3<Exact>> planes)
      : view_(view), planes_(planes), next_(2 * view.arcs.size(), -1) {
    std::vector<std::vector<int>> leaving(view.vertices.size());
    for (int half = 0; half < static_cast<int>(next_.size()); ++half) {
      const int start = Start(half);
      if (start >= 0) {
        leaving[Index(start)].push_back(half);
      } else {
        next_[Index(half)] = half;  // a circle without vertices
      }
    }
    for (std::size_t v = 0; v < leaving.size(); ++v)
      Link(view.vertices[v].direction, leaving[v]);
  }

  std::vector<std::vector<ViewLoop>> Trace() const {
    std::vector<std::vector<ViewLoop>> loops(Index(view_.region_count));
    std::vector<bool> done(next_.size(), false);
    for (int first = 0; first < static_cast<int>(next_.size()); ++first) {
      const int region = Region(first);
      if (done[Index(first)] || region < 0) continue;
      ViewLoop loop;
      int half = first;
      do {
        done[Index(half)] = true;
        loop.arcs.push_back(half / 2);
        half = next_[Index(half)];
      } while (half != first);
      loops[Index(region)].push_back(std::move(loop));
    }
    return loops;
  }

 private:
  [[nodiscard]] int Start(int half) const {
    const GluedArc& arc = view_.arcs[Index(half / 2)];
    return half % 2 == 0 ? arc.from : arc.to;
  }

  /// On the left.
  [[nodiscard]] int Region(int half) const {
    const GluedArc& arc = view_.arcs[Index(half / 2)];
    return half % 2 == 0 ? arc.left_region : arc.right_region;
  }

  /// Of the half-arc's plane, to its left.
  [[nodiscard]] Vec3<Exact> Normal(int half) const {
    const Vec3<Exact>& plane = planes_[Index(half / 2)];
    return half % 2 == 0 ? plane : -plane;
  }

  /// Tells each half-arc that arrives in direction d how it goes on. leaving:
  /// the half-arcs that start there.
  void Link(const Vec3<Exact>& d, std::vector<int>& leaving) {
    if (leaving.empty()) return;
    // Seen against d, the tangents turn as the normals of the planes do.
    const Vec3<Exact> first = Normal(leaving.front());
    const auto lower = [&](const Vec3<Exact>& n) {
      const Sign side = SignOf(Determinant(d, first, n));
      if (side != Sign::kZero) return side == Sign::kNegative;
      return SignOf(Dot(first, n)) == Sign::kNegative;
    };
    std::ranges::sort(leaving, [&](int a, int b) {
      const Vec3<Exact> n = Normal(a);
      const Vec3<Exact> m = Normal(b);
      const bool n_lower = lower(n);
      if (n_lower != lower(m)) return !n_lower;
      return SignOf(Determinant(d, n, m)) == Sign::kPositive;
    });
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const std::size_t before = (i + leaving.size() - 1) % leaving.size();
      next_[Index(Twin(leaving[i]))] = leaving[before];
    }
  }

  const GluedView& view_;
  std::span<const Vec3<Exact>> planes_;
  std::vector<int> next_;  ///< per half-arc
};

}  // namespace

std::vector<std::vector<ViewLoop>> LoopsOf(
    const GluedView& view, std::span<const Vec3<Exact>> planes) {
  return LoopTracer(view, planes).Trace();
}

}  // namespace truelux
