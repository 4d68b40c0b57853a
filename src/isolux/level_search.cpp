// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/level_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

/// Values of E.
struct ValueRange {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;

  void Take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }

  [[nodiscard]] bool HasOneOf(std::span<const double> levels) const {
    const auto first = std::ranges::lower_bound(levels, least);
    return first != levels.end() && *first <= most;
  }
};

/// The range on the hull of some points around the centre of a triangle.
ValueRange RangeOver(const KnownTriangle& known, const PlanPoint& centre,
                     std::span<const PlanPoint> points) {
  ValueRange range;
  double farthest = 0;
  for (const PlanPoint& p : points) {
    const PlanPoint way = p - centre;
    range.Take(known.centre.light.value + Dot(known.centre.gradient, way));
    farthest = std::max(farthest, LengthOf(way));
  }
  const double slack =
      known.centre.light.bound +
      farthest * (known.change.rate * farthest / 2 + known.change.jump +
                  known.centre.gradient_bound);
  return {range.least - slack, range.most + slack};
}

}  // namespace

LevelSearch::LevelSearch(const LightProbe& probe, const LightFeatures& features,
                         PlanMesh mesh)
    : probe_(probe), features_(features), mesh_(std::move(mesh)) {
  const auto whole = std::make_shared<const Sight>(WholeSight(features));
  known_.resize(mesh_.triangles().size());
  for (KnownTriangle& known : known_)
    known.sight = whole;
}

void LevelSearch::Halve(int triangle, std::vector<int>& changed) {
  mesh_.Halve(triangle, [&](int old, int added) {
    KnownTriangle child;
    child.sight = known_[static_cast<std::size_t>(old)].sight;
    known_.resize(std::max(known_.size(), static_cast<std::size_t>(added) + 1));
    known_[static_cast<std::size_t>(old)] = child;
    known_[static_cast<std::size_t>(added)] = child;
    changed.push_back(old);
    changed.push_back(added);
  });
}

void LevelSearch::RefineTo(double longest) {
  std::vector<int> open;
  for (std::size_t i = 0; i < mesh_.triangles().size(); ++i)
    open.push_back(static_cast<int>(i));
  while (!open.empty()) {
    const int next = open.back();
    open.pop_back();
    if (mesh_.LongestSideOf(next) > longest) Halve(next, open);
  }
}

void LevelSearch::SamplePoints(int threads, const Watch& watch) {
  const std::size_t first = values_.size();
  values_.resize(mesh_.points().size());
  Progress progress(values_.size() - first, "points", watch);
  ForEachInParallel(
      values_.size() - first, threads, progress, [&](std::size_t i) {
        values_[first + i] = probe_.ValueAt(mesh_.points()[first + i]);
      });
}

void LevelSearch::Know(int triangle, std::span<const double> levels) {
  KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
  const std::array<PlanPoint, 3> corners = mesh_.CornersOf(triangle);
  const PlanPoint centre = mesh_.CentreOf(triangle);
  known.radius = 0;
  for (const PlanPoint& corner : corners)
    known.radius = std::max(known.radius, LengthOf(corner - centre));
  known.centre = probe_.SampleAt(centre);
  known.is_known = true;
  if (!known.centre.is_defined) {
    known.change = kUnknownChange;
    return;
  }
  known.sight =
      std::make_shared<const Sight>(Narrowed(features_, *known.sight, corners));
  known.is_dark = known.centre.light.value == 0 &&
                  known.centre.light.bound == 0 &&
                  std::ranges::all_of(*known.sight, [](const LampSight& lamp) {
                    return lamp.edges.empty();
                  });
  if (known.is_dark) {
    known.change = {0, 0};
    known.is_settled = true;
    return;
  }
  // What would be too much for the level that asks for least.
  const double slope = LengthOf(known.centre.gradient);
  double useful = HUGE_VAL;
  for (const double level : levels) {
    const double apart = std::fabs(known.centre.light.value - level);
    useful =
        std::min(useful, std::max(slope, 2 * (apart / known.radius - slope)));
  }
  known.change =
      GradientChangeOver(features_, *known.sight, corners, centre, 2 * useful);
  known.is_settled = IsSettled(triangle, levels);
}

std::pair<double, double> LevelSearch::RangeOf(int triangle) const {
  const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
  if (!known.is_known || !known.centre.is_defined) return {-HUGE_VAL, HUGE_VAL};
  const ValueRange range =
      RangeOver(known, mesh_.CentreOf(triangle), mesh_.CornersOf(triangle));
  return {range.least, range.most};
}

bool LevelSearch::IsSettled(int triangle,
                            std::span<const double> levels) const {
  const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
  const std::array<PlanPoint, 3> corners = mesh_.CornersOf(triangle);
  const PlanPoint centre = mesh_.CentreOf(triangle);
  if (!RangeOver(known, centre, corners).HasOneOf(levels)) return true;
  const double change =
      known.change.Over(known.radius) + known.centre.gradient_bound;
  if (!(LengthOf(known.centre.gradient) > change)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<PlanPoint, 2> side = {corners[(k + 1) % 3],
                                           corners[(k + 2) % 3]};
    const PlanPoint way = side[1] - side[0];
    if (std::fabs(Dot(known.centre.gradient, way)) > change * LengthOf(way))
      continue;
    if (RangeOver(known, centre, side).HasOneOf(levels)) return false;
  }
  return true;
}

void LevelSearch::Settle(std::span<const double> levels,
                         const SearchLimits& limits, int threads,
                         const Watch& watch) {
  std::vector<int> open;
  for (std::size_t i = 0; i < mesh_.triangles().size(); ++i)
    open.push_back(static_cast<int>(i));
  while (!open.empty()) {
    // Each once, and in an order that does not depend on how they came.
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    {
      Progress progress(open.size(), "triangles", watch);
      ForEachInParallel(open.size(), threads, progress,
                        [&](std::size_t i) { Know(open[i], levels); });
    }
    std::vector<int> changed;
    for (const int triangle : open) {
      const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
      // Halving another one may have changed it meanwhile.
      if (!known.is_known || known.is_settled) continue;
      if (mesh_.LongestSideOf(triangle) < 2 * limits.smallest) continue;
      if (mesh_.triangles().size() >= limits.most_triangles) continue;
      Halve(triangle, changed);
    }
    open = std::move(changed);
  }
  SamplePoints(threads, watch);
}

}  // namespace truelux
