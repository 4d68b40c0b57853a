// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/prepared_surface.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/scalar_channel.h"
#include "scene/emitters.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// Before anything is asked triangles are at most this share of the size.
constexpr double kCoarse = 1.0 / 16;

}  // namespace

Rgb WeightsOf(const Scene& scene, std::optional<ScalarChannel> channel) {
  if (!channel && IsGrey(scene)) return {1, 0, 0};
  return SharesOf(channel.value_or(ScalarChannel::kLuminance));
}

ContourPlace PlaceOf(SideKind kind) {
  switch (kind) {
    case SideKind::kInner:
      break;
    case SideKind::kKink:
      return ContourPlace::kKink;
    case SideKind::kJump:
      return ContourPlace::kJump;
    case SideKind::kOutline:
      return ContourPlace::kOutline;
  }
  return ContourPlace::kInside;
}

SideSearch::SideSearch(const Oracle& oracle, SurfaceSide side,
                       const EdgePlanes& planes, const Rgb& weights,
                       int threads, const Watch& watch)
    : side_(std::move(side)),
      first_(FirstMeshOf(oracle.scene(), side_.plan, side_.faces,
                         side_.lines.lines)),
      features_(oracle.scene(), side_.plan, planes, oracle.options().emission,
                weights),
      probe_(oracle, side_.plan, weights),
      search_(probe_, features_, first_.mesh) {
  search_.RefineTo(kCoarse * first_.scale.size);
  search_.SamplePoints(threads, watch);
}

PreparedSurface PrepareSurface(const Oracle& oracle, const std::string& surface,
                               std::optional<ScalarChannel> channel,
                               int threads, const Watch& watch) {
  const Scene& scene = oracle.scene();
  const Rgb weights = WeightsOf(scene, channel);
  PreparedSurface prepared;
  for (const Face& face : scene.faces()) {
    double exitance = 0;
    for (std::size_t k = 0; k < 3; ++k)
      exitance += weights[k] * face.emission[k];
    prepared.most_exitance = std::max(prepared.most_exitance, exitance);
  }
  if (oracle.options().emission == Emission::kRadiance)
    prepared.most_exitance *= std::numbers::pi;
  NamedSurface named = SurfaceNamed(scene, surface);
  prepared.notes = std::move(named.notes);
  const EdgePlanes planes = EdgePlanesOf(
      scene, CornersOfSurface(scene, named.frame), kMostEdgeLines, watch.stop);
  for (SurfaceSide& side : SidesOf(scene, named.frame, planes, watch)) {
    prepared.sides.push_back(std::make_unique<SideSearch>(
        oracle, std::move(side), planes, weights, threads, watch));
    prepared.size =
        std::max(prepared.size, prepared.sides.back()->first().scale.size);
  }
  return prepared;
}

}  // namespace truelux
