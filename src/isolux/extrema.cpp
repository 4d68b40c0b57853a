// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/extrema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "isolux/summits.h"

namespace truelux {
namespace {

/// Of the size of the surface.
constexpr double kSmallGroup = 0x1p-10;

/// A side of a group beyond which a settled triangle lies; the group is on its
/// left.
struct BorderSide {
  int from = 0;
  int to = 0;
  int beyond = 0;  ///< the settled triangle
};

class CriticalReader {
 public:
  CriticalReader(const MeshSearch& search, const LightFeatures& features)
      : search_(search), mesh_(search.mesh()), features_(features) {
    for (const PlanPoint& p : mesh_.points())
      size_ = std::max(size_, LengthOf(p - mesh_.points().front()));
  }

  CriticalPoints Read() {
    for (const LightValue& value : search_.values()) {
      found_.values.Take(value.value - value.bound);
      found_.values.Take(value.value + value.bound);
    }
    summit_of_.assign(mesh_.triangles().size(), -1);
    for (const Summit& summit : SummitsOf(search_, features_)) {
      for (const int triangle : summit.triangles) {
        summit_of_[static_cast<std::size_t>(triangle)] =
            static_cast<int>(found_.points.size());
      }
      found_.points.push_back(summit.point);
    }
    groups_ = GroupsOf(search_);
    for (std::size_t i = 0; i < groups_.size(); ++i)
      ReadGroup(i);
    ReadPoints();
    found_.values.least = std::max(0.0, found_.values.least);
    return std::move(found_);
  }

 private:
  [[nodiscard]] const KnownTriangle& KnownOf(int triangle) const {
    return search_.known()[static_cast<std::size_t>(triangle)];
  }

  [[nodiscard]] const LightValue& ValueAt(int point) const {
    return search_.values()[static_cast<std::size_t>(point)];
  }

  [[nodiscard]] const PlanPoint& At(int point) const {
    return mesh_.points()[static_cast<std::size_t>(point)];
  }

  [[nodiscard]] std::vector<BorderSide> BorderOf(std::size_t group) const {
    std::vector<BorderSide> border;
    for (const int triangle : groups_[group]) {
      const PlanTriangle& t = mesh_.At(triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.neighbors[k] < 0 || !KnownOf(t.neighbors[k]).is_settled) continue;
        border.push_back(
            {t.corners[(k + 1) % 3], t.corners[(k + 2) % 3], t.neighbors[k]});
      }
    }
    return border;
  }

  void ReadGroup(std::size_t group) {
    ValueRange all;
    for (const int triangle : groups_[group]) {
      const ValueRange range = LightRangeOf(search_, features_, triangle);
      all.Take(range.least);
      all.Take(range.most);
    }
    found_.values.Take(all.least);
    found_.values.Take(all.most);
    if (IsPartOfSummit(group)) return;
    if (IndexOf(group, BorderOf(group)) == -1) {
      AddSaddle(group, all);
    } else {
      found_.undecided.push_back({groups_[group], all});
    }
  }

  /// Whether a summit is in the group, and the group is so small that what else
  /// there may be in it is not told apart.
  bool IsPartOfSummit(std::size_t group) {
    for (const int triangle : groups_[group]) {
      const int summit = summit_of_[static_cast<std::size_t>(triangle)];
      if (summit < 0) continue;
      CriticalPoint& point = found_.points[static_cast<std::size_t>(summit)];
      const double radius = RadiusOf(group, point.at);
      if (radius > kSmallGroup * size_) continue;
      point.radius = std::max(point.radius, radius);
      return true;
    }
    return false;
  }

  /// The farthest corner of a group from a point.
  [[nodiscard]] double RadiusOf(std::size_t group, const PlanPoint& at) const {
    double radius = 0;
    for (const int triangle : groups_[group]) {
      for (const PlanPoint& corner : mesh_.CornersOf(triangle))
        radius = std::max(radius, LengthOf(corner - at));
    }
    return radius;
  }

  void AddSaddle(std::size_t group, const ValueRange& all) {
    int flattest = groups_[group].front();
    for (const int triangle : groups_[group]) {
      if (LengthOf(KnownOf(triangle).centre.gradient) <
          LengthOf(KnownOf(flattest).centre.gradient)) {
        flattest = triangle;
      }
    }
    const PlanPoint at = mesh_.CentreOf(flattest);
    found_.points.push_back({ExtremumKind::kSaddle, at,
                             KnownOf(flattest).centre.light, all,
                             RadiusOf(group, at), SideKind::kInner});
  }

  /// How often the gradient turns around a group; nothing if that has no
  /// meaning. From one border side to the next it turns by less than half a
  /// turn: in the point between them it is less than a right angle from both
  /// triangles' centres.
  [[nodiscard]] std::optional<int> IndexOf(
      std::size_t group, const std::vector<BorderSide>& border) const {
    for (const int triangle : groups_[group]) {
      for (const SideKind kind : mesh_.At(triangle).kinds) {
        if (kind != SideKind::kInner) return std::nullopt;
      }
    }
    if (border.empty()) return std::nullopt;
    std::map<int, const BorderSide*> from;
    for (const BorderSide& side : border) {
      if (KnownOf(side.beyond).is_dark) return std::nullopt;
      if (!from.emplace(side.from, &side).second) return std::nullopt;
    }
    double turn = 0;
    std::size_t count = 0;
    const BorderSide* side = &border.front();
    do {
      const auto next = from.find(side->to);
      if (next == from.end()) return std::nullopt;
      const PlanPoint& a = KnownOf(side->beyond).centre.gradient;
      const PlanPoint& b = KnownOf(next->second->beyond).centre.gradient;
      turn += std::atan2(Cross(a, b), Dot(a, b));
      side = next->second;
      ++count;
    } while (side != &border.front());
    if (count != border.size()) return std::nullopt;
    return static_cast<int>(std::lround(turn / (2 * std::numbers::pi)));
  }

  /// Points on lines and outlines.
  void ReadPoints() {
    std::map<int, std::vector<int>> around;
    std::map<int, SideKind> on;
    for (const PlanTriangle& t : mesh_.triangles()) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.kinds[k] == SideKind::kInner) continue;
        for (const std::size_t end : {(k + 1) % 3, (k + 2) % 3}) {
          SideKind& kind = on[t.corners[end]];
          kind = std::max(kind, t.kinds[k]);
        }
      }
    }
    for (std::size_t i = 0; i < mesh_.triangles().size(); ++i) {
      for (const int corner : mesh_.triangles()[i].corners) {
        if (on.contains(corner)) around[corner].push_back(static_cast<int>(i));
      }
    }
    for (const auto& [point, triangles] : around) {
      const bool is_settled = std::ranges::all_of(triangles, [&](int triangle) {
        return KnownOf(triangle).is_settled && !KnownOf(triangle).is_dark;
      });
      if (!is_settled ||
          summit_of_[static_cast<std::size_t>(triangles.front())] >= 0) {
        continue;
      }
      ReadPoint(point, triangles, on.at(point), 1);
      ReadPoint(point, triangles, on.at(point), -1);
    }
  }

  /// Whether E times sense falls in all directions from a point.
  void ReadPoint(int point, const std::vector<int>& triangles, SideKind on,
                 double sense) {
    bool falls = true;
    for (const int triangle : triangles) {
      const PlanTriangle& t = mesh_.At(triangle);
      const KnownTriangle& known = KnownOf(triangle);
      const std::size_t k = static_cast<std::size_t>(
          std::ranges::find(t.corners, point) - t.corners.begin());
      const std::array<PlanPoint, 2> ways = {
          At(t.corners[(k + 1) % 3]) - At(point),
          At(t.corners[(k + 2) % 3]) - At(point)};
      const PlanPoint up = sense * known.centre.gradient;
      const double change = ChangeIn(known);
      // Straight up within the triangle.
      if (Cross(ways[0], up) > 0 && Cross(up, ways[1]) > 0) return;
      for (const PlanPoint& way : ways) {
        const double length = LengthOf(way);
        const double rise = Dot(up, way);
        if (rise > change * length) return;
        falls = falls && rise < -change * length;
      }
    }
    const LightValue& value = ValueAt(point);
    const ValueRange range = {value.value - value.bound,
                              value.value + value.bound};
    if (falls) {
      found_.points.push_back(
          {sense > 0 ? ExtremumKind::kMaximum : ExtremumKind::kMinimum,
           At(point), value, range, 0, on});
    } else {
      found_.undecided.push_back({triangles, range});
    }
  }

  const MeshSearch& search_;
  const PlanMesh& mesh_;
  const LightFeatures& features_;
  std::vector<std::vector<int>> groups_;
  std::vector<int> summit_of_;  ///< of each triangle, index into points; or -1
  double size_ = 0;             ///< a length like that of the surface
  CriticalPoints found_;
};

}  // namespace

std::vector<std::vector<int>> GroupsOf(const MeshSearch& search) {
  const PlanMesh& mesh = search.mesh();
  std::map<int, std::vector<int>> around;  // of corners, unsettled ones
  for (std::size_t i = 0; i < search.known().size(); ++i) {
    if (search.known()[i].is_settled) continue;
    for (const int corner : mesh.triangles()[i].corners)
      around[corner].push_back(static_cast<int>(i));
  }
  std::vector<bool> is_done(search.known().size(), false);
  std::vector<std::vector<int>> groups;
  for (std::size_t i = 0; i < is_done.size(); ++i) {
    if (is_done[i] || search.known()[i].is_settled) continue;
    std::vector<int>& group = groups.emplace_back();
    std::vector<int> open = {static_cast<int>(i)};
    is_done[i] = true;
    while (!open.empty()) {
      const int next = open.back();
      open.pop_back();
      group.push_back(next);
      for (const int corner : mesh.At(next).corners) {
        for (const int other : around.at(corner)) {
          if (is_done[static_cast<std::size_t>(other)]) continue;
          is_done[static_cast<std::size_t>(other)] = true;
          open.push_back(other);
        }
      }
    }
    std::ranges::sort(group);
  }
  return groups;
}

CriticalPoints CriticalPointsOf(const MeshSearch& search,
                                const LightFeatures& features) {
  return CriticalReader(search, features).Read();
}

}  // namespace truelux
