// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "isolux/lamp_pieces.h"
#include "isolux/occlusion.h"

namespace truelux {
namespace {

Vec3<double> OnSurface(const PlanPoint& p) {
  return {p.s, p.t, 0};
}

/// The planes that hold the hull of points and of a lamp on their lower side.
/// There may be fewer than the hull has: the shaft is then wider.
class ShaftPlanes {
 public:
  ShaftPlanes(std::span<const PlanPoint> points,
              std::span<const Vec3<double>> lamp, double slack)
      : points_(points), lamp_(lamp), slack_(slack) {
    for (std::size_t i = 0; i < lamp.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        for (const PlanPoint& p : points)
          Add(lamp[i], lamp[k], OnSurface(p));
      }
      for (std::size_t k = 0; k < points.size(); ++k) {
        Add(OnSurface(points[k]), OnSurface(points[(k + 1) % points.size()]),
            lamp[i]);
      }
    }
  }

  /// Cuts what is above a plane away. False if nothing is left.
  bool Clip(const LightEdge& edge, SightEdge& part) const {
    return std::ranges::all_of(planes_, [&](const LightPlane& plane) {
      return ClipBy(plane, edge, part, slack_);
    });
  }

  /// Whether all points are above one plane.
  [[nodiscard]] bool Misses(std::span<const Vec3<double>> points) const {
    return std::ranges::any_of(planes_, [&](const LightPlane& plane) {
      return std::ranges::all_of(points, [&](const Vec3<double>& p) {
        return plane.HeightOf(p) > slack_;
      });
    });
  }

  /// Keeps the part below a height over the plane.
  static bool ClipBy(const LightPlane& plane, const LightEdge& edge,
                     SightEdge& part, double most) {
    const double a = plane.HeightOf(edge.ends[0]) - most;
    const double b = plane.HeightOf(edge.ends[1]) - most;
    if (a <= 0 && b <= 0) return true;
    if (a > 0 && b > 0) return false;
    const double share = a / (a - b);
    if (a > 0) {
      part.from = std::max(part.from, share);
    } else {
      part.to = std::min(part.to, share);
    }
    return part.from <= part.to;
  }

 private:
  void Add(const Vec3<double>& a, const Vec3<double>& b,
           const Vec3<double>& c) {
    Vec3<double> normal = Cross(b - a, c - a);
    const double length = LengthOf(normal);
    if (!(length > slack_ * slack_)) return;
    normal = (1 / length) * normal;
    LightPlane plane{normal, Dot(normal, a)};
    bool is_above = false;
    bool is_below = false;
    const auto look = [&](double height) {
      is_above = is_above || height > slack_;
      is_below = is_below || height < -slack_;
    };
    for (const PlanPoint& p : points_)
      look(plane.HeightOf(p));
    for (const Vec3<double>& p : lamp_)
      look(plane.HeightOf(p));
    if (is_above && is_below) return;
    if (is_above) {
      plane.normal = -plane.normal;
      plane.offset = -plane.offset;
    }
    planes_.push_back(plane);
  }

  std::span<const PlanPoint> points_;
  std::span<const Vec3<double>> lamp_;
  double slack_;
  std::vector<LightPlane> planes_;
};

struct Range {
  double least = 0;
  double most = 0;
};

Range HeightsOver(const LightPlane& plane, std::span<const PlanPoint> points) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const PlanPoint& p : points) {
    const double height = plane.HeightOf(p);
    range.least = std::min(range.least, height);
    range.most = std::max(range.most, height);
  }
  return range;
}

/// Whether facets meet at the edge, as seen from all the points, on both its
/// sides.
bool IsFold(const LightEdge& edge, std::span<const PlanPoint> points,
            double slack) {
  if (!edge.has_two_facets) return false;
  const Range one = HeightsOver(edge.planes[0], points);
  const Range other = HeightsOver(edge.planes[1], points);
  return (one.least >= -slack && other.least >= -slack) ||
         (one.most <= slack && other.most <= slack);
}

bool LiesIn(const LightPlane& plane, const LightEdge& edge, double slack) {
  return std::fabs(plane.HeightOf(edge.ends[0])) <= slack &&
         std::fabs(plane.HeightOf(edge.ends[1])) <= slack;
}

/// Whether all of a blocker is before a lamp: then it hides the lamp wherever a
/// ray to the lamp meets it.
bool IsBefore(const LightPlane& lamp, std::span<const Vec3<double>> corners,
              double slack) {
  return std::ranges::all_of(
      corners, [&](const Vec3<double>& p) { return lamp.HeightOf(p) > slack; });
}

/// Adds what no occluder hides of a part of an edge.
void AddSeen(const LightEdge& edge, const SightEdge& part,
             std::span<const Occluder> occluders,
             std::vector<SightEdge>& seen) {
  std::vector<EdgePart> left = {{part.from, part.to}};
  std::vector<EdgePart> next;
  for (const Occluder& occluder : occluders) {
    next.clear();
    for (const EdgePart& piece : left) {
      const EdgePart hidden =
          occluder.HiddenOf(edge.ends[0], edge.ends[1], piece);
      if (hidden.from > hidden.to) {
        next.push_back(piece);
        continue;
      }
      if (piece.from < hidden.from) next.push_back({piece.from, hidden.from});
      if (hidden.to < piece.to) next.push_back({hidden.to, piece.to});
    }
    left.swap(next);
    if (left.empty()) return;
  }
  for (const EdgePart& piece : left)
    seen.push_back({part.edge, piece.from, piece.to});
}

}  // namespace

Sight WholeSight(const LightFeatures& features) {
  Sight sight;
  for (std::size_t i = 0; i < features.lamps().size(); ++i) {
    LampSight& lamp = sight.emplace_back();
    lamp.lamp = static_cast<int>(i);
    for (std::size_t k = 0; k < features.edges().size(); ++k)
      lamp.edges.push_back({static_cast<int>(k), 0, 1});
    for (std::size_t k = 0; k < features.blockers().size(); ++k)
      lamp.blockers.push_back(static_cast<int>(k));
  }
  return sight;
}

Sight Narrowed(const LightFeatures& features, const Sight& sight,
               std::span<const PlanPoint> points) {
  const double slack = 0x1p-40 * features.size();
  Sight narrowed;
  for (const LampSight& old : sight) {
    const Lamp& lamp = features.lamps()[static_cast<std::size_t>(old.lamp)];
    const Range heights = HeightsOver(lamp.plane, points);
    if (heights.most <= slack) continue;
    const ShaftPlanes shaft(points, lamp.hull, slack);
    LampSight kept;
    kept.lamp = old.lamp;
    std::vector<Occluder> occluders;
    for (const int index : old.blockers) {
      const Blocker& blocker =
          features.blockers()[static_cast<std::size_t>(index)];
      if (shaft.Misses(blocker.corners)) continue;
      if (!IsBefore(lamp.plane, blocker.corners, slack)) continue;
      kept.blockers.push_back(index);
      Occluder occluder(blocker, points, slack);
      if (occluder.IsUsable()) occluders.push_back(std::move(occluder));
    }
    if (std::ranges::any_of(occluders, [&](const Occluder& occluder) {
          return std::ranges::all_of(lamp.hull, [&](const Vec3<double>& p) {
            return occluder.Hides(p);
          });
        })) {
      continue;
    }
    const LightPlane behind{-lamp.plane.normal, -lamp.plane.offset};
    std::vector<SightEdge> before;
    for (SightEdge part : old.edges) {
      const LightEdge& edge =
          features.edges()[static_cast<std::size_t>(part.edge)];
      const bool is_lamps = LiesIn(lamp.plane, edge, slack);
      if (!is_lamps && IsFold(edge, points, slack)) continue;
      if (!ShaftPlanes::ClipBy(behind, edge, part, slack)) continue;
      if (!ShaftPlanes::ClipBy(lamp.plane, edge, part, heights.most + slack))
        continue;
      if (!shaft.Clip(edge, part)) continue;
      AddSeen(edge, part, occluders, is_lamps ? kept.edges : before);
    }
    kept.lamp_edges = kept.edges.size();
    if (before.empty()) {
      kept.edges.clear();
      kept.lamp_edges = 0;
    }
    kept.edges.insert(kept.edges.end(), before.begin(), before.end());
    narrowed.push_back(std::move(kept));
  }
  return narrowed;
}

}  // namespace truelux
