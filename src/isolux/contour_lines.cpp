// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "isolux/contour_chord.h"
#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

/// A side of the mesh, with the levels that are passed along it.
struct CrossedSide {
  int triangle = 0;  ///< one that has it
  std::size_t side = 0;
  std::size_t first_level = 0;
  std::size_t first_point = 0;  ///< that of the first level; others follow
  std::size_t count = 0;
};

/// A contour within a triangle, from point to point.
struct Link {
  std::size_t level = 0;
  std::size_t from = 0;  ///< what is larger is on the left
  std::size_t to = 0;
  ContourPiece piece;
};

/// The contours in one triangle, by levels.
struct CrossedTriangle {
  int triangle = 0;
  std::vector<Link> links;
};

/// Twice the area of three points.
double Turn(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
  return Cross(b - a, c - a);
}

bool DoCross(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c,
             const PlanPoint& d) {
  return Turn(a, b, c) * Turn(a, b, d) < 0 && Turn(c, d, a) * Turn(c, d, b) < 0;
}

class Tracer {
 public:
  Tracer(const LightProbe& probe, const LightFeatures& features,
         const MeshSearch& search, std::span<const double> levels,
         const ContourWishes& wishes)
      : probe_(probe),
        features_(features),
        search_(search),
        mesh_(search.mesh()),
        levels_(levels),
        finder_(probe, wishes.half_width),
        chord_(wishes.chord) {}

  /// Finds which sides are crossed.
  void FindLinks() {
    for (std::size_t i = 0; i < mesh_.triangles().size(); ++i) {
      CrossedTriangle crossed;
      crossed.triangle = static_cast<int>(i);
      for (std::size_t level = 0; level < levels_.size(); ++level)
        AddLink(level, crossed);
      if (!crossed.links.empty()) triangles_.push_back(std::move(crossed));
    }
    points_.resize(point_count_);
  }

  [[nodiscard]] std::size_t side_count() const { return sides_.size(); }

  [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }

  /// The points of all levels on a side. The bracket of each begins at the one
  /// before, so that they are in order also where E is not monotonic.
  void FindPoints(std::size_t i) {
    const CrossedSide& found = sides_[i];
    const PlanTriangle& t = mesh_.At(found.triangle);
    int p = t.corners[(found.side + 1) % 3];
    int q = t.corners[(found.side + 2) % 3];
    if (ValueAt(q).value < ValueAt(p).value) std::swap(p, q);
    const KnownTriangle& known =
        search_.known()[static_cast<std::size_t>(found.triangle)];
    LevelCrossing crossing{mesh_.points()[static_cast<std::size_t>(p)],
                           mesh_.points()[static_cast<std::size_t>(q)],
                           ValueAt(p),
                           ValueAt(q),
                           mesh_.CentreOf(found.triangle),
                           known.centre.gradient,
                           t.kinds[found.side],
                           t.seams[found.side]};
    const std::array<int, 2> beside = {found.triangle, t.neighbors[found.side]};
    const auto in_region = [&](const PlanPoint& point) {
      return std::ranges::any_of(beside, [&](int triangle) {
        return triangle >= 0 && mesh_.Holds(triangle, point);
      });
    };
    for (std::size_t k = 0; k < found.count; ++k) {
      ContourPoint& point = points_[found.first_point + k];
      const double level = levels_[found.first_level + k];
      point = finder_.OnCrossing(crossing, level, in_region);
      crossing.below = point.at;
      crossing.at_below = {level, 0};
    }
  }

  /// Divides the chords of a triangle, more finely while two of them cross.
  void DivideLinks(std::size_t i) {
    CrossedTriangle& crossed = triangles_[i];
    double longest = chord_;
    constexpr int kMostRounds = 6;
    for (int round = 0; round < kMostRounds; ++round) {
      const ChordDivider divider(probe_, features_, finder_, longest);
      for (Link& link : crossed.links)
        Divide(crossed.triangle, divider, link);
      if (!HasCrossing(crossed)) return;
      longest /= 4;
    }
  }

  /// Puts links together.
  [[nodiscard]] std::vector<ContourLine> Lines() const {
    std::vector<const Link*> out(points_.size(), nullptr);
    std::vector<bool> has_in(points_.size(), false);
    std::vector<std::vector<std::size_t>> of_level(levels_.size());
    for (const CrossedTriangle& crossed : triangles_) {
      for (const Link& link : crossed.links) {
        out[link.from] = &link;
        has_in[link.to] = true;
        of_level[link.level].push_back(link.from);
      }
    }
    std::vector<ContourLine> lines;
    std::vector<bool> is_used(points_.size(), false);
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      // Open ones begin where nothing comes in; the rest is closed.
      for (const bool is_open : {true, false}) {
        for (const std::size_t first : of_level[level]) {
          if (is_used[first] || (is_open && has_in[first])) continue;
          lines.push_back(Follow(first, out, is_used));
          lines.back().level = level;
        }
      }
    }
    return lines;
  }

 private:
  [[nodiscard]] const LightValue& ValueAt(int point) const {
    return search_.values()[static_cast<std::size_t>(point)];
  }

  void AddLink(std::size_t level, CrossedTriangle& crossed) {
    const PlanTriangle& t = mesh_.At(crossed.triangle);
    std::array<bool, 3> is_above;
    for (std::size_t k = 0; k < 3; ++k)
      is_above[k] = ValueAt(t.corners[k]).value >= levels_[level];
    for (std::size_t k = 0; k < 3; ++k) {
      // The corner that differs from both others.
      const std::size_t next = (k + 1) % 3;
      const std::size_t last = (k + 2) % 3;
      if (is_above[k] == is_above[next] || is_above[k] == is_above[last])
        continue;
      // Going from the side opposite to `last`, which runs from k to next, to
      // that opposite to `next` has corner k on the left.
      Link link;
      link.level = level;
      link.from = PointOn(crossed.triangle, last, level);
      link.to = PointOn(crossed.triangle, next, level);
      if (!is_above[k]) std::swap(link.from, link.to);
      crossed.links.push_back(std::move(link));
    }
  }

  /// The index of the point of a level on a side.
  std::size_t PointOn(int triangle, std::size_t side, std::size_t level) {
    const PlanTriangle& t = mesh_.At(triangle);
    const std::pair<int, int> ends =
        std::minmax(t.corners[(side + 1) % 3], t.corners[(side + 2) % 3]);
    const auto [entry, is_new] = names_.emplace(ends, sides_.size());
    if (is_new) {
      const auto [low, high] =
          std::minmax(ValueAt(ends.first).value, ValueAt(ends.second).value);
      // Passed are those above the lower end and not above the higher one.
      const auto first = std::ranges::upper_bound(levels_, low);
      const auto end = std::ranges::upper_bound(levels_, high);
      CrossedSide found{triangle, side,
                        static_cast<std::size_t>(first - levels_.begin()),
                        point_count_, static_cast<std::size_t>(end - first)};
      point_count_ += found.count;
      sides_.push_back(found);
    }
    const CrossedSide& found = sides_[entry->second];
    return found.first_point + level - found.first_level;
  }

  void Divide(int triangle, const ChordDivider& divider, Link& link) const {
    const KnownTriangle& known =
        search_.known()[static_cast<std::size_t>(triangle)];
    const ContourPoint& from = points_[link.from];
    const ContourPoint& to = points_[link.to];
    link.piece = {{}, {HUGE_VAL}};
    // Elsewhere more than one arc may be there.
    if (!known.is_settled || !from.is_certified || !to.is_certified) return;
    ChordRegion region;
    const auto corners = mesh_.CornersOf(triangle);
    region.corners.assign(corners.begin(), corners.end());
    region.sample = known.centre;
    region.at = mesh_.CentreOf(triangle);
    region.change = known.change;
    region.sight = known.sight;
    link.piece = divider.Divide(region, from, to, levels_[link.level]);
  }

  [[nodiscard]] std::vector<PlanPoint> PathOf(const Link& link) const {
    std::vector<PlanPoint> path = {points_[link.from].at};
    for (const ContourPoint& point : link.piece.points)
      path.push_back(point.at);
    path.push_back(points_[link.to].at);
    return path;
  }

  [[nodiscard]] bool HasCrossing(const CrossedTriangle& crossed) const {
    for (std::size_t i = 1; i < crossed.links.size(); ++i) {
      const auto one = PathOf(crossed.links[i - 1]);
      const auto other = PathOf(crossed.links[i]);
      for (std::size_t k = 1; k < one.size(); ++k) {
        for (std::size_t m = 1; m < other.size(); ++m) {
          if (DoCross(one[k - 1], one[k], other[m - 1], other[m])) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] ContourLine Follow(std::size_t first,
                                   const std::vector<const Link*>& out,
                                   std::vector<bool>& is_used) const {
    ContourLine line;
    std::size_t at = first;
    line.points.push_back(points_[at]);
    while (out[at] != nullptr && !is_used[at]) {
      is_used[at] = true;
      const Link& link = *out[at];
      line.points.insert(line.points.end(), link.piece.points.begin(),
                         link.piece.points.end());
      line.widths.insert(line.widths.end(), link.piece.widths.begin(),
                         link.piece.widths.end());
      at = link.to;
      line.is_closed = at == first;
      if (!line.is_closed) line.points.push_back(points_[at]);
    }
    return line;
  }

  const LightProbe& probe_;
  const LightFeatures& features_;
  const MeshSearch& search_;
  const PlanMesh& mesh_;
  std::span<const double> levels_;
  ContourPointFinder finder_;
  double chord_;
  std::map<std::pair<int, int>, std::size_t> names_;  ///< of sides
  std::vector<CrossedSide> sides_;
  std::size_t point_count_ = 0;
  std::vector<ContourPoint> points_;
  std::vector<CrossedTriangle> triangles_;
};

}  // namespace

std::vector<ContourLine> ContourLinesOf(const LightProbe& probe,
                                        const LightFeatures& features,
                                        const MeshSearch& search,
                                        std::span<const double> levels,
                                        const ContourWishes& wishes,
                                        int threads, const Watch& watch) {
  Tracer tracer(probe, features, search, levels, wishes);
  tracer.FindLinks();
  {
    Progress progress(tracer.side_count(), "sides", watch);
    ForEachInParallel(tracer.side_count(), threads, progress,
                      [&](std::size_t i) { tracer.FindPoints(i); });
  }
  Progress progress(tracer.triangle_count(), "triangles with contours", watch);
  ForEachInParallel(tracer.triangle_count(), threads, progress,
                    [&](std::size_t i) { tracer.DivideLinks(i); });
  return tracer.Lines();
}

}  // namespace truelux
