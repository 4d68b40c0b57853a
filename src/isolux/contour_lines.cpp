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

/// A side of the mesh that a contour crosses.
struct SideCrossing {
  int triangle = 0;
  std::size_t side = 0;
  ContourPoint point;
};

/// A contour within a triangle, from one crossing to another.
struct Link {
  int triangle = 0;
  std::size_t from = 0;  ///< crossings; what is larger is on the left
  std::size_t to = 0;
  ContourPiece piece;
};

/// The contours of one level.
class LevelTracer {
 public:
  LevelTracer(const LightProbe& probe, const LightFeatures& features,
              const LevelSearch& search, double level,
              const ContourWishes& wishes)
      : probe_(probe),
        features_(features),
        search_(search),
        mesh_(search.mesh()),
        level_(level),
        finder_(probe, wishes.half_width),
        divider_(probe, features, finder_, wishes.chord) {}

  /// Finds which sides are crossed.
  void FindLinks() {
    for (std::size_t i = 0; i < mesh_.triangles().size(); ++i) {
      const auto triangle = static_cast<int>(i);
      const PlanTriangle& t = mesh_.At(triangle);
      std::array<bool, 3> is_above;
      for (std::size_t k = 0; k < 3; ++k)
        is_above[k] = IsAbove(t.corners[k]);
      for (std::size_t k = 0; k < 3; ++k) {
        // The corner that differs from both others.
        const std::size_t next = (k + 1) % 3;
        const std::size_t last = (k + 2) % 3;
        if (is_above[k] == is_above[next] || is_above[k] == is_above[last])
          continue;
        // Sides opposite to `last` (k to next) and to `next` (last to k). Going
        // from the former to the latter has corner k on the left.
        std::size_t from = NameOf(triangle, last);
        std::size_t to = NameOf(triangle, next);
        if (!is_above[k]) std::swap(from, to);
        links_.push_back({triangle, from, to, {}});
      }
    }
  }

  [[nodiscard]] std::size_t crossing_count() const { return crossings_.size(); }

  [[nodiscard]] std::size_t link_count() const { return links_.size(); }

  void FindPoint(std::size_t i) {
    SideCrossing& found = crossings_[i];
    const PlanTriangle& t = mesh_.At(found.triangle);
    int p = t.corners[(found.side + 1) % 3];
    int q = t.corners[(found.side + 2) % 3];
    if (IsAbove(p)) std::swap(p, q);
    const auto at = [this](int point) {
      return mesh_.points()[static_cast<std::size_t>(point)];
    };
    const auto value = [this](int point) {
      return search_.values()[static_cast<std::size_t>(point)];
    };
    const KnownTriangle& known =
        search_.known()[static_cast<std::size_t>(found.triangle)];
    Crossing crossing{at(p),
                      at(q),
                      value(p),
                      value(q),
                      mesh_.CentreOf(found.triangle),
                      known.centre.gradient,
                      t.kinds[found.side]};
    const std::array<int, 2> beside = {found.triangle, t.neighbors[found.side]};
    found.point =
        finder_.OnCrossing(crossing, level_, [&](const PlanPoint& point) {
          return std::ranges::any_of(beside, [&](int triangle) {
            return triangle >= 0 && Holds(triangle, point);
          });
        });
  }

  void DivideLink(std::size_t i) {
    Link& link = links_[i];
    const KnownTriangle& known =
        search_.known()[static_cast<std::size_t>(link.triangle)];
    ChordRegion region;
    const auto corners = mesh_.CornersOf(link.triangle);
    region.corners.assign(corners.begin(), corners.end());
    region.sample = known.centre;
    region.at = mesh_.CentreOf(link.triangle);
    // Where the level is not settled more than one arc may be there.
    region.change = known.is_settled ? known.change : kUnknownChange;
    region.sight = known.sight;
    const ContourPoint& from = crossings_[link.from].point;
    const ContourPoint& to = crossings_[link.to].point;
    if (!known.is_settled || !from.is_certified || !to.is_certified) {
      link.piece.widths = {HUGE_VAL};
      return;
    }
    link.piece = divider_.Divide(region, from, to, level_);
  }

  /// Puts links together.
  [[nodiscard]] std::vector<ContourLine> Lines() const {
    std::vector<int> out(crossings_.size(), -1);
    std::vector<bool> has_in(crossings_.size(), false);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      out[links_[i].from] = static_cast<int>(i);
      has_in[links_[i].to] = true;
    }
    std::vector<ContourLine> lines;
    std::vector<bool> is_used(links_.size(), false);
    const auto follow = [&](std::size_t first) {
      ContourLine line;
      std::size_t at = first;
      line.points.push_back(crossings_[at].point);
      while (out[at] >= 0 && !is_used[static_cast<std::size_t>(out[at])]) {
        const auto next = static_cast<std::size_t>(out[at]);
        is_used[next] = true;
        const Link& link = links_[next];
        for (const ContourPoint& point : link.piece.points)
          line.points.push_back(point);
        line.widths.insert(line.widths.end(), link.piece.widths.begin(),
                           link.piece.widths.end());
        at = link.to;
        if (at == first) {
          line.is_closed = true;
          break;
        }
        line.points.push_back(crossings_[at].point);
      }
      lines.push_back(std::move(line));
    };
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      if (!has_in[i]) follow(i);
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (!is_used[i]) follow(links_[i].from);
    }
    return lines;
  }

 private:
  /// Whether E at a point of the mesh counts as above the level.
  [[nodiscard]] bool IsAbove(int point) const {
    return search_.values()[static_cast<std::size_t>(point)].value >= level_;
  }

  [[nodiscard]] bool Holds(int triangle, const PlanPoint& point) const {
    const auto c = mesh_.CornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      if (Cross(c[(k + 1) % 3] - c[k], point - c[k]) < 0) return false;
    }
    return true;
  }

  std::size_t NameOf(int triangle, std::size_t side) {
    const PlanTriangle& t = mesh_.At(triangle);
    const std::pair<int, int> ends =
        std::minmax(t.corners[(side + 1) % 3], t.corners[(side + 2) % 3]);
    const auto [entry, is_new] = names_.emplace(ends, crossings_.size());
    if (is_new) crossings_.push_back({triangle, side, {}});
    return entry->second;
  }

  const LightProbe& probe_;
  const LightFeatures& features_;
  const LevelSearch& search_;
  const PlanMesh& mesh_;
  double level_;
  ContourPointFinder finder_;
  ChordDivider divider_;
  std::map<std::pair<int, int>, std::size_t> names_;  ///< of crossings
  std::vector<SideCrossing> crossings_;
  std::vector<Link> links_;
};

}  // namespace

std::vector<ContourLine> ContourLinesOf(const LightProbe& probe,
                                        const LightFeatures& features,
                                        const LevelSearch& search,
                                        std::span<const double> levels,
                                        const ContourWishes& wishes,
                                        int threads, const Watch& watch) {
  std::vector<ContourLine> all;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    LevelTracer tracer(probe, features, search, levels[i], wishes);
    tracer.FindLinks();
    {
      Progress progress(tracer.crossing_count(), "points of contours", watch);
      ForEachInParallel(tracer.crossing_count(), threads, progress,
                        [&](std::size_t k) { tracer.FindPoint(k); });
    }
    {
      Progress progress(tracer.link_count(), "chords", watch);
      ForEachInParallel(tracer.link_count(), threads, progress,
                        [&](std::size_t k) { tracer.DivideLink(k); });
    }
    for (ContourLine& line : tracer.Lines()) {
      line.level = i;
      all.push_back(std::move(line));
    }
  }
  return all;
}

}  // namespace truelux
