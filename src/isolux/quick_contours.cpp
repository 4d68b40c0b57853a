// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/quick_contours.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "isolux/contour_lines.h"
#include "isolux/isolux_run.h"
#include "isolux/prepared_surface.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// Whether a level is passed between the corners of a triangle.
bool IsCrossed(const MeshSearch& search, int triangle,
               std::span<const double> levels) {
  ValueRange range;
  for (const int corner : search.mesh().At(triangle).corners)
    range.Take(search.values()[static_cast<std::size_t>(corner)].value);
  return std::ranges::upper_bound(levels, range.least) !=
         std::ranges::upper_bound(levels, range.most);
}

/// Halves triangles that are crossed until they are small.
void Approach(MeshSearch& search, std::span<const double> levels,
              double spacing, int threads, const Watch& watch) {
  for (;;) {
    std::vector<int> crossed;
    for (std::size_t i = 0; i < search.mesh().triangles().size(); ++i) {
      const auto triangle = static_cast<int>(i);
      if (search.mesh().LongestSideOf(triangle) > spacing &&
          IsCrossed(search, triangle, levels))
        crossed.push_back(triangle);
    }
    if (crossed.empty()) return;
    search.Halve(crossed);
    search.SamplePoints(threads, watch);
  }
}

}  // namespace

std::vector<IsoluxContour> QuickContoursOf(const Oracle& oracle,
                                           const std::string& surface,
                                           std::span<const double> levels,
                                           std::optional<ScalarChannel> channel,
                                           double spacing, int threads,
                                           const Watch& watch) {
  constexpr double kElsewhere = 3;
  const Scene& scene = oracle.scene();
  const NamedSurface named = SurfaceNamed(scene, surface);
  std::vector<IsoluxContour> contours;
  for (const bool is_reverse : {false, true}) {
    std::vector<int> faces = FacesOfSide(named.frame, is_reverse);
    if (faces.empty()) continue;
    // Kinks do not end lines, so that only jumps are needed.
    ExactSurfaceLines jumps;
    jumps.lines =
        JumpLinesOf(scene, named.frame, faces, is_reverse, watch.stop);
    SideSearch side(
        oracle,
        {std::move(faces), PlanFrame(scene, named.frame, is_reverse),
         std::move(jumps)},
        EdgePlanes{}, WeightsOf(scene, channel), threads, watch);
    MeshSearch& search = side.search();
    search.RefineTo(kElsewhere * spacing);
    search.SamplePoints(threads, watch);
    Approach(search, levels, spacing, threads, watch);
    const ContourWishes wishes = {.half_width = spacing / 16, .chord = spacing};
    for (const ContourLine& line :
         ContourLinesOf(side.probe(), side.features(), search, levels, wishes,
                        threads, watch))
      contours.push_back(ContourOf(side.plan(), line, levels));
  }
  std::ranges::stable_sort(contours, {}, &IsoluxContour::level);
  return contours;
}

}  // namespace truelux
