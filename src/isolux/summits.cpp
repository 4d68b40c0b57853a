// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/summits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "isolux/light_ceiling.h"

namespace truelux {
namespace {

constexpr std::size_t kMostTriangles = 4096;

class SummitFinder {
 public:
  SummitFinder(const MeshSearch& search, const LightFeatures& features)
      : search_(search), mesh_(search.mesh()), features_(features) {
    around_.resize(mesh_.points().size());
    for (std::size_t i = 0; i < mesh_.triangles().size(); ++i) {
      for (const int corner : mesh_.triangles()[i].corners)
        around_[static_cast<std::size_t>(corner)].push_back(
            static_cast<int>(i));
    }
  }

  std::vector<Summit> Find() const {
    std::vector<Summit> summits;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      for (const ExtremumKind kind :
           {ExtremumKind::kMaximum, ExtremumKind::kMinimum}) {
        if (!IsPeak(static_cast<int>(i), kind)) continue;
        if (auto summit = Climb(static_cast<int>(i), kind))
          Add(*std::move(summit), summits);
      }
    }
    return summits;
  }

 private:
  /// Two points that are as high may lie in one group: then one of them is
  /// enough.
  static void Add(Summit summit, std::vector<Summit>& summits) {
    std::ranges::sort(summit.triangles);
    for (const Summit& other : summits) {
      std::vector<int> shared;
      std::ranges::set_intersection(summit.triangles, other.triangles,
                                    std::back_inserter(shared));
      if (other.point.kind == summit.point.kind && !shared.empty()) return;
    }
    summits.push_back(std::move(summit));
  }

  static double SenseOf(ExtremumKind kind) {
    return kind == ExtremumKind::kMaximum ? 1 : -1;
  }

  [[nodiscard]] const LightValue& ValueAt(int point) const {
    return search_.values()[static_cast<std::size_t>(point)];
  }

  /// Whether no neighbour is higher, and none as high comes before it.
  [[nodiscard]] bool IsPeak(int point, ExtremumKind kind) const {
    const double sense = SenseOf(kind);
    const double height = ValueAt(point).value;
    if (height == 0) return false;
    for (const int triangle : around_[static_cast<std::size_t>(point)]) {
      for (const int other : mesh_.At(triangle).corners) {
        if (other == point) continue;
        const double its = ValueAt(other).value;
        if (sense * its > sense * height || (its == height && other < point))
          return false;
      }
    }
    return true;
  }

  /// The triangles around a peak that may be as high as it is; nothing if one
  /// is proven to be higher, or if there are too many.
  [[nodiscard]] std::optional<Summit> Climb(int point,
                                            ExtremumKind kind) const {
    const double sense = SenseOf(kind);
    const LightValue& value = ValueAt(point);
    // What is proven to be lower than the peak is not part of it.
    const double least = sense * value.value - value.bound;
    const auto height_of = [sense](const ValueRange& range) {
      return sense > 0 ? range.most : -range.least;
    };
    Summit summit;
    std::set<int> seen;
    std::vector<int> open;
    const auto add = [&](int triangle) {
      if (triangle >= 0 && seen.insert(triangle).second)
        open.push_back(triangle);
    };
    for (const int triangle : around_[static_cast<std::size_t>(point)])
      add(triangle);
    ValueRange all;
    while (!open.empty()) {
      const int triangle = open.back();
      open.pop_back();
      const ValueRange range = LightRangeOf(search_, features_, triangle);
      if (height_of(range) < least) continue;
      if (summit.triangles.size() >= kMostTriangles) return std::nullopt;
      summit.triangles.push_back(triangle);
      all.Take(range.least);
      all.Take(range.most);
      const PlanTriangle& t = mesh_.At(triangle);
      for (const int corner : t.corners) {
        if (sense * ValueAt(corner).value > sense * value.value)
          return std::nullopt;
        // Around corners, too: what is left out lies all around.
        for (const int other : around_[static_cast<std::size_t>(corner)])
          add(other);
      }
    }
    summit.point = {kind,  mesh_.points()[static_cast<std::size_t>(point)],
                    value, all,
                    0,     OnOf(point)};
    if (sense > 0) {
      summit.point.range.least = value.value - value.bound;
    } else {
      summit.point.range.most = value.value + value.bound;
    }
    for (const int triangle : summit.triangles) {
      for (const PlanPoint& corner : mesh_.CornersOf(triangle)) {
        summit.point.radius =
            std::max(summit.point.radius, LengthOf(corner - summit.point.at));
      }
    }
    return summit;
  }

  /// The line that a point lies on.
  [[nodiscard]] SideKind OnOf(int point) const {
    SideKind on = SideKind::kInner;
    for (const int triangle : around_[static_cast<std::size_t>(point)]) {
      const PlanTriangle& t = mesh_.At(triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.corners[(k + 1) % 3] == point || t.corners[(k + 2) % 3] == point)
          on = std::max(on, t.kinds[k]);
      }
    }
    return on;
  }

  const MeshSearch& search_;
  const PlanMesh& mesh_;
  const LightFeatures& features_;
  std::vector<std::vector<int>> around_;  ///< triangles, of each point
};

}  // namespace

ValueRange LightRangeOf(const MeshSearch& search, const LightFeatures& features,
                        int triangle) {
  ValueRange range = search.RangeOf(triangle);
  range.least = std::max(0.0, range.least);
  const KnownTriangle& known =
      search.known()[static_cast<std::size_t>(triangle)];
  // A bound that is far from what was met may be worse than no blockers.
  if (range.most > 1.01 * known.centre.light.value) {
    range.most =
        std::min(range.most, LightCeiling(features, *known.sight,
                                          search.mesh().CornersOf(triangle)));
  }
  return range;
}

std::vector<Summit> SummitsOf(const MeshSearch& search,
                              const LightFeatures& features) {
  return SummitFinder(search, features).Find();
}

}  // namespace truelux
