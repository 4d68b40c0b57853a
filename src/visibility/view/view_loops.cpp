// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/view_loops.h"

#include <algorithm>
#include <cstddef>

namespace truelux {
namespace {

/// Half-arc 2 a runs through arc a as it is, 2 a + 1 the other way.
using HalfArcId = Id<struct HalfArcTag>;

constexpr HalfArcId Twin(HalfArcId half) {
  return HalfArcId(half.value() ^ 1);
}

constexpr GluedArcId ArcOf(HalfArcId half) {
  return GluedArcId(half.value() / 2);
}

constexpr bool IsForward(HalfArcId half) {
  return half.value() % 2 == 0;
}

class LoopTracer {
 public:
  LoopTracer(const GluedView& view,
             IdSpan<GluedArcId, const Vec3<Exact>> planes)
      : view_(view), planes_(planes), next_(2 * view.arcs.size()) {
    IdVector<GluedVertexId, std::vector<HalfArcId>> leaving(
        view.vertices.size());
    for (const HalfArcId half : next_.ids()) {
      const GluedVertexId start = Start(half);
      if (start.valid()) {
        leaving[start].push_back(half);
      } else {
        next_[half] = half;  // a circle without vertices
      }
    }
    for (const GluedVertexId v : leaving.ids())
      Link(view.vertices[v].direction, leaving[v]);
  }

  IdVector<RegionId, std::vector<ViewLoop>> Trace() const {
    IdVector<RegionId, std::vector<ViewLoop>> loops(
        static_cast<std::size_t>(view_.region_count));
    IdVector<HalfArcId, bool> done(next_.size(), false);
    for (const HalfArcId first : next_.ids()) {
      const RegionId region = Region(first);
      if (done[first] || !region.valid()) continue;
      ViewLoop loop;
      HalfArcId half = first;
      do {
        done[half] = true;
        loop.arcs.push_back(ArcOf(half).value());
        half = next_[half];
      } while (half != first);
      loops[region].push_back(std::move(loop));
    }
    return loops;
  }

 private:
  [[nodiscard]] GluedVertexId Start(HalfArcId half) const {
    const GluedArc& arc = view_.arcs[ArcOf(half)];
    return IsForward(half) ? arc.from : arc.to;
  }

  /// On the left.
  [[nodiscard]] RegionId Region(HalfArcId half) const {
    const GluedArc& arc = view_.arcs[ArcOf(half)];
    return IsForward(half) ? arc.left_region : arc.right_region;
  }

  /// Of the half-arc's plane, to its left.
  [[nodiscard]] Vec3<Exact> Normal(HalfArcId half) const {
    const Vec3<Exact>& plane = planes_[ArcOf(half)];
    return IsForward(half) ? plane : -plane;
  }

  /// Tells each half-arc that arrives in direction d how it goes on. leaving:
  /// the half-arcs that start there.
  void Link(const Vec3<Exact>& d, std::vector<HalfArcId>& leaving) {
    if (leaving.empty()) return;
    // Seen against d, the tangents turn as the normals of the planes do.
    const Vec3<Exact> first = Normal(leaving.front());
    const auto lower = [&](const Vec3<Exact>& n) {
      const Sign side = SignOf(Determinant(d, first, n));
      if (side != Sign::kZero) return side == Sign::kNegative;
      return SignOf(Dot(first, n)) == Sign::kNegative;
    };
    std::ranges::sort(leaving, [&](HalfArcId a, HalfArcId b) {
      const Vec3<Exact> n = Normal(a);
      const Vec3<Exact> m = Normal(b);
      const bool n_lower = lower(n);
      if (n_lower != lower(m)) return !n_lower;
      return SignOf(Determinant(d, n, m)) == Sign::kPositive;
    });
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const std::size_t before = (i + leaving.size() - 1) % leaving.size();
      next_[Twin(leaving[i])] = leaving[before];
    }
  }

  const GluedView& view_;
  IdSpan<GluedArcId, const Vec3<Exact>> planes_;
  IdVector<HalfArcId, HalfArcId> next_;
};

}  // namespace

IdVector<RegionId, std::vector<ViewLoop>> LoopsOf(
    const GluedView& view, IdSpan<GluedArcId, const Vec3<Exact>> planes) {
  return LoopTracer(view, planes).Trace();
}

}  // namespace truelux
