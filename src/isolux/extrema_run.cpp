// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/extrema_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "isolux/critical_goal.h"
#include "isolux/extrema.h"
#include "isolux/prepared_surface.h"
#include "isolux/summits.h"
#include "run/parallel.h"

namespace truelux {
namespace {

/// Everywhere triangles are halved to this share of the size.
constexpr double kCoarsest = 0x1p-9;
/// Around points they are halved further, in these steps.
constexpr double kStep = 0x1p-3;
constexpr double kFinest = 0x1p-21;
/// More triangles are no point.
constexpr std::size_t kMostAround = 8192;
constexpr std::size_t kMostOfSummit = 512;
constexpr int kMostSteps = 32;
constexpr std::size_t kMostTriangles = 4'000'000;

/// Whether a corner of the group touches a triangle that is proven dark: there E
/// falls to 0 along a line, together with its gradient.
bool TouchesDarkness(const std::vector<int>& group,
                     const std::vector<bool>& is_dark_point,
                     const PlanMesh& mesh) {
  return std::ranges::any_of(group, [&](int triangle) {
    return std::ranges::any_of(mesh.At(triangle).corners, [&](int corner) {
      return is_dark_point[static_cast<std::size_t>(corner)];
    });
  });
}

std::vector<bool> DarkPoints(const MeshSearch& search) {
  std::vector<bool> is_dark(search.mesh().points().size(), false);
  for (std::size_t i = 0; i < search.known().size(); ++i) {
    if (!search.known()[i].is_dark) continue;
    for (const int corner : search.mesh().triangles()[i].corners)
      is_dark[static_cast<std::size_t>(corner)] = true;
  }
  return is_dark;
}

/// Halves a group around a point as long as no more triangles are left of it
/// than there were.
void Narrow(MeshSearch& search, std::vector<int> group, double size,
            int threads, const Watch& watch) {
  const CriticalGoal goal;
  double smallest = kCoarsest * kStep;
  while (smallest >= kFinest && group.size() <= kMostAround &&
         search.mesh().triangles().size() < kMostTriangles) {
    const std::size_t before = group.size();
    group = search.Settle(goal, {smallest * size, 0, kMostTriangles},
                          std::move(group), threads, watch);
    if (group.size() > before + before / 2 + 16) return;
    smallest *= kStep;
  }
}

/// Halves what may be as high as summits, as long as it gets smaller.
void NarrowSummits(SideSearch& side, double size, int threads,
                   const Watch& watch) {
  MeshSearch& search = side.search();
  // Nothing more is halved for the goal itself.
  const SearchLimits none = {HUGE_VAL, 0, kMostTriangles};
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<int> open;
    for (const Summit& summit : SummitsOf(search, side.features())) {
      if (summit.triangles.size() > kMostOfSummit) continue;
      for (const int triangle : summit.triangles) {
        if (search.mesh().LongestSideOf(triangle) > 2 * kFinest * size)
          open.push_back(triangle);
      }
    }
    if (open.empty() || search.mesh().triangles().size() >= kMostTriangles)
      return;
    search.Settle(CriticalGoal(), none, search.Halve(open), threads, watch);
  }
}

CriticalPoints Search(SideSearch& side, double size, int threads,
                      const Watch& watch) {
  side.search().Settle(CriticalGoal(), {kCoarsest * size, 0, kMostTriangles},
                       threads, watch);
  const std::vector<bool> is_dark = DarkPoints(side.search());
  for (const std::vector<int>& group : GroupsOf(side.search())) {
    if (!TouchesDarkness(group, is_dark, side.search().mesh()))
      Narrow(side.search(), group, size, threads, watch);
  }
  NarrowSummits(side, size, threads, watch);
  return CriticalPointsOf(side.search(), side.features());
}

}  // namespace

SurfaceExtrema FindExtrema(const Oracle& oracle, const std::string& surface,
                           const ExtremaOptions& options, const Watch& watch) {
  CheckThreads(options.threads);
  PreparedSurface prepared =
      PrepareSurface(oracle, surface, options.channel, options.threads, watch);
  SurfaceExtrema result;
  result.notes = prepared.notes;
  result.size = prepared.size;
  ValueRange values;
  for (const auto& side : prepared.sides) {
    const CriticalPoints found =
        Search(*side, prepared.size, options.threads, watch);
    values.Take(found.values.least);
    values.Take(std::min(prepared.most_exitance, found.values.most));
    for (const CriticalPoint& point : found.points) {
      result.points.push_back(
          {point.kind, side->plan().PointAt(point.at), point.value.value,
           point.range.least,
           std::min(prepared.most_exitance, point.range.most), point.radius,
           PlaceOf(point.on)});
    }
    const PlanMesh& mesh = side->search().mesh();
    for (const UnsettledGroup& group : found.undecided) {
      UndecidedRegion& region = result.undecided.emplace_back();
      region.least = group.range.least;
      region.most = std::min(prepared.most_exitance, group.range.most);
      for (const int triangle : group.triangles) {
        auto& corners = region.triangles.emplace_back();
        const auto places = mesh.CornersOf(triangle);
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = side->plan().PointAt(places[k]);
        result.undecided_area += mesh.AreaOf(triangle);
      }
    }
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const double area = mesh.AreaOf(static_cast<int>(i));
      result.area += area;
      if (side->search().known()[i].is_dark) result.dark_area += area;
    }
    result.evaluations += side->probe().count();
  }
  if (!prepared.sides.empty()) {
    result.least = values.least;
    result.most = values.most;
  }
  return result;
}

}  // namespace truelux
