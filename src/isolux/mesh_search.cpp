// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/mesh_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
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

MeshSearch::MeshSearch(const LightProbe& probe, const LightFeatures& features,
                       PlanMesh mesh)
    : probe_(&probe), features_(&features), mesh_(std::move(mesh)) {
  const auto whole = std::make_shared<const Sight>(WholeSight(features));
  known_.resize(mesh_.triangles().size());
  for (KnownTriangle& known : known_)
    known.sight = whole;
}

void MeshSearch::Halve(int triangle, std::vector<int>& changed) {
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

std::vector<int> MeshSearch::Halve(const std::vector<int>& triangles) {
  std::vector<int> changed;
  for (const int triangle : triangles)
    Halve(triangle, changed);
  return changed;
}

void MeshSearch::RefineTo(double longest) {
  std::vector<int> open;
  for (std::size_t i = 0; i < mesh_.triangles().size(); ++i)
    open.push_back(static_cast<int>(i));
  while (!open.empty()) {
    const int next = open.back();
    open.pop_back();
    if (mesh_.LongestSideOf(next) > longest) Halve(next, open);
  }
}

void MeshSearch::SamplePoints(int threads, const Watch& watch) {
  const std::size_t first = values_.size();
  values_.resize(mesh_.points().size());
  Progress progress(values_.size() - first, "points", watch);
  ForEachInParallel(
      values_.size() - first, threads, progress, [&](std::size_t i) {
        values_[first + i] = probe_->ValueAt(mesh_.points()[first + i]);
      });
}

bool MeshSearch::IsDark(const KnownTriangle& known,
                        const PlanPoint& centre) const {
  if (!known.centre.is_defined || known.centre.light.value != 0 ||
      known.centre.light.bound != 0) {
    return false;
  }
  // Where no edge is before a lamp, all points see the same of it; and the
  // centre, which is in front of it, sees nothing.
  return std::ranges::all_of(*known.sight, [&](const LampSight& lamp) {
    const LightPlane& plane =
        features_->lamps()[static_cast<std::size_t>(lamp.lamp)].plane;
    return lamp.edges.empty() && plane.HeightOf(centre) > 0;
  });
}

void MeshSearch::Know(int triangle, const SearchGoal& goal) {
  KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
  const std::array<PlanPoint, 3> corners = mesh_.CornersOf(triangle);
  const PlanPoint centre = mesh_.CentreOf(triangle);
  if (!known.is_known) {
    known.is_known = true;
    known.radius = 0;
    for (const PlanPoint& corner : corners)
      known.radius = std::max(known.radius, LengthOf(corner - centre));
    known.centre = probe_->SampleAt(centre);
    known.change = kUnknownChange;
    known.sight = std::make_shared<const Sight>(
        Narrowed(*features_, *known.sight, corners));
    known.is_dark = IsDark(known, centre);
    if (known.is_dark) known.change = {0, 0};
  }
  if (known.centre.is_defined && !std::isfinite(known.change.rate)) {
    known.change = GradientChangeOver(*features_, *known.sight, corners, centre,
                                      2 * goal.UsefulChange(known));
  }
  known.is_settled = known.is_dark || goal.IsSettled(mesh_, triangle, known);
}

ValueRange MeshSearch::RangeOf(int triangle) const {
  const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
  if (!known.is_known || !known.centre.is_defined) return {-HUGE_VAL, HUGE_VAL};
  return RangeOver(known, mesh_.CentreOf(triangle), mesh_.CornersOf(triangle));
}

void MeshSearch::Settle(const SearchGoal& goal, const SearchLimits& limits,
                        int threads, const Watch& watch) {
  std::vector<int> all;
  for (std::size_t i = 0; i < mesh_.triangles().size(); ++i)
    all.push_back(static_cast<int>(i));
  Settle(goal, limits, std::move(all), threads, watch);
}

std::vector<int> MeshSearch::Settle(const SearchGoal& goal,
                                    const SearchLimits& limits,
                                    std::vector<int> triangles, int threads,
                                    const Watch& watch) {
  std::vector<int> left;
  while (!triangles.empty()) {
    // Each once, and in an order that does not depend on how they came.
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()),
                    triangles.end());
    {
      Progress progress(triangles.size(), "triangles", watch);
      ForEachInParallel(triangles.size(), threads, progress,
                        [&](std::size_t i) { Know(triangles[i], goal); });
    }
    std::vector<int> changed;
    for (const int triangle : triangles) {
      const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
      // Halving another one may have changed it meanwhile.
      if (!known.is_known || known.is_settled) continue;
      const double least = goal.IsFlat(known)
                               ? std::max(limits.smallest, limits.plateau)
                               : limits.smallest;
      if (mesh_.LongestSideOf(triangle) < 2 * least ||
          mesh_.triangles().size() >= limits.most_triangles) {
        left.push_back(triangle);
      } else {
        Halve(triangle, changed);
      }
    }
    triangles = std::move(changed);
  }
  SamplePoints(threads, watch);
  // Later ones may have halved them.
  std::erase_if(left, [this](int triangle) {
    const KnownTriangle& known = known_[static_cast<std::size_t>(triangle)];
    return known.is_known && known.is_settled;
  });
  return left;
}

}  // namespace truelux
