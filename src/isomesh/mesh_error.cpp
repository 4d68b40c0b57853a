// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

/// In [0, 1), the same on every system.
double Share(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

std::array<double, 3> WeightsAt(const LightMesh& mesh,
                                const PlanTriangle& triangle,
                                const PlanPoint& p) {
  const auto at = [&](std::size_t k) {
    return mesh.vertices[static_cast<std::size_t>(triangle.corners[k])].at;
  };
  const double all = Cross(at(1) - at(0), at(2) - at(0));
  const double second = Cross(p - at(0), at(2) - at(0)) / all;
  const double third = Cross(at(1) - at(0), p - at(0)) / all;
  return {1 - second - third, second, third};
}

InterpolationError SummedUp(std::vector<double> errors) {
  InterpolationError result;
  if (errors.empty()) return result;
  std::ranges::sort(errors);
  double sum = 0;
  for (const double error : errors)
    sum += error;
  result.mean = sum / static_cast<double>(errors.size());
  result.at_99 = errors[(errors.size() - 1) * 99 / 100];
  result.most = errors.back();
  return result;
}

}  // namespace

std::vector<LitPoint> SampleOf(const LightProbe& probe, const PlanMesh& mesh,
                               std::size_t count, int threads,
                               const Watch& watch) {
  std::vector<double> areas;  // up to and with each triangle
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    sum += mesh.AreaOf(static_cast<int>(i));
    areas.push_back(sum);
  }
  std::mt19937_64 random;  // with the seed that the standard gives
  std::vector<LitPoint> sample(count);
  for (LitPoint& point : sample) {
    const auto found = std::ranges::upper_bound(areas, Share(random) * sum);
    const auto triangle = std::min<std::size_t>(
        static_cast<std::size_t>(found - areas.begin()), areas.size() - 1);
    const auto corners = mesh.CornersOf(static_cast<int>(triangle));
    double p = Share(random);
    double q = Share(random);
    if (p + q > 1) {
      p = 1 - p;
      q = 1 - q;
    }
    point.at = corners[0] + p * (corners[1] - corners[0]) +
               q * (corners[2] - corners[0]);
  }
  Progress progress(count, "points of a sample", watch);
  ForEachInParallel(count, threads, progress, [&](std::size_t i) {
    sample[i].value = probe.ValueAt(sample[i].at).value;
  });
  return sample;
}

InterpolationError ErrorOf(const LightProbe& probe, const RefinedPlane& plane,
                           const LightMesh& mesh,
                           std::span<const LitPoint> sample, int threads,
                           const Watch& watch) {
  std::vector<double> errors;
  for (const LitPoint& point : sample) {
    const std::optional<int> index = plane.TriangleAt(point.at);
    if (!index) continue;
    const PlanTriangle& triangle =
        mesh.triangles[static_cast<std::size_t>(*index)];
    errors.push_back(
        std::fabs(mesh.ValueIn(triangle, WeightsAt(mesh, triangle, point.at)) -
                  point.value));
  }
  InterpolationError result = SummedUp(std::move(errors));
  std::vector<double> middles(mesh.triangles.size());
  Progress progress(middles.size(), "triangles", watch);
  constexpr std::array<double, 3> kMiddle = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  ForEachInParallel(middles.size(), threads, progress, [&](std::size_t i) {
    const PlanTriangle& triangle = mesh.triangles[i];
    middles[i] =
        std::fabs(mesh.ValueIn(triangle, kMiddle) -
                  probe.ValueAt(mesh.PointIn(triangle, kMiddle)).value);
  });
  for (const double error : middles)
    result.most = std::max(result.most, error);
  return result;
}

}  // namespace truelux
