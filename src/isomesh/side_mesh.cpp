// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/side_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "isomesh/mesh_error.h"
#include "isomesh/refined_plane.h"
#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

constexpr std::size_t kSample = 10'000;

/// Of the points at which a triangle's error is looked at: with their weights all
/// alike, they integrate squares exactly.
constexpr std::array<std::array<double, 3>, 3> kChecks = {
    {{2.0 / 3, 1.0 / 6, 1.0 / 6},
     {1.0 / 6, 2.0 / 3, 1.0 / 6},
     {1.0 / 6, 1.0 / 6, 2.0 / 3}}};

/// The outline alone. Faces may meet with corners on each other's sides.
EdgePlan OutlinePlan(const Scene& scene, const SideSearch& side,
                     const EdgeTolerances& tolerances) {
  const auto at = [&](int vertex) {
    const Vec3<double> place =
        side.plan().PlaceOf(scene.vertices()[static_cast<std::size_t>(vertex)]);
    return PlanPoint{place.x, place.y};
  };
  std::vector<Seam> seams;
  for (const auto& [a, b] : OutlineOf(scene, side.side().faces))
    seams.push_back({at(a), at(b), SideKind::kOutline, -1});
  return EdgePlanOf(seams, {}, tolerances);
}

class MeshMaker {
 public:
  MeshMaker(const Scene& scene, const SideSearch& side,
            const MeshWishes& wishes, int threads, const Watch& watch)
      : scene_(scene),
        side_(side),
        wishes_(wishes),
        threads_(threads),
        watch_(watch) {}

  SideMesh Make(std::span<const ContourLine> contours) {
    SideMesh result;
    result.plan = EdgePlanOf(side_.first().seams, contours, wishes_.tolerances);
    RefinedPlane plane(result.plan,
                       [&](const PlanPoint& p) { return IsOnSurface(p); });
    Refine(plane, result);
    const std::vector<LitPoint> sample =
        SampleOf(side_.probe(), side_.first().mesh, kSample, threads_, watch_);
    result.interpolation =
        ErrorOf(side_.probe(), plane, result.mesh, sample, threads_, watch_);
    Compare(sample, result);
    return result;
  }

 private:
  [[nodiscard]] bool IsOnSurface(const PlanPoint& p) const {
    const PlanMesh& mesh = side_.first().mesh;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      if (mesh.Holds(static_cast<int>(i), p)) return true;
    }
    return false;
  }

  LightMesh Lit(const SharedMesh& mesh) {
    return LightMeshOf(side_.probe(), mesh, side_.first().scale.margin,
                       wishes_.error, known_, threads_, watch_);
  }

  /// Divides triangles with too large an error, and takes what becomes of them.
  void Refine(RefinedPlane& plane, SideMesh& result) {
    std::map<Corners, double> errors;  // of triangles that were looked at
    for (std::size_t points = 0;;) {
      const SharedMesh shared = plane.Mesh();
      LightMesh mesh = Lit(shared);
      Look(shared, mesh, errors);
      std::map<Corners, double> bad;
      std::size_t small = 0;
      for (std::size_t i = 0; i < shared.triangles.size(); ++i) {
        const Corners corners = OrderedCorners(shared.triangles[i].corners);
        const double error = errors.at(corners);
        if (error <= wishes_.error) continue;
        if (LongestOf(mesh, mesh.triangles[i]) <= wishes_.smallest) {
          ++small;
        } else {
          bad[corners] = error;
        }
      }
      // If the last round has divided none of them, no other one will.
      if (bad.empty() || plane.point_count() >= wishes_.most_vertices ||
          plane.point_count() == points) {
        result.mesh = std::move(mesh);
        result.unfinished = small + bad.size();
        return;
      }
      points = plane.point_count();
      plane.Divide(bad, wishes_.most_vertices, watch_.stop);
    }
  }

  /// Finds the errors of new triangles.
  void Look(const SharedMesh& shared, const LightMesh& mesh,
            std::map<Corners, double>& errors) {
    std::vector<std::pair<const PlanTriangle*, double*>> open;
    for (std::size_t i = 0; i < shared.triangles.size(); ++i) {
      const auto [entry, is_new] =
          errors.emplace(OrderedCorners(shared.triangles[i].corners), 0);
      if (is_new) open.push_back({&mesh.triangles[i], &entry->second});
    }
    Progress progress(open.size(), "triangles", watch_);
    ForEachInParallel(open.size(), threads_, progress, [&](std::size_t i) {
      const PlanTriangle& triangle = *open[i].first;
      for (const auto& weights : kChecks) {
        const double value =
            side_.probe().ValueAt(mesh.PointIn(triangle, weights)).value;
        *open[i].second =
            std::max(*open[i].second,
                     std::fabs(value - mesh.ValueIn(triangle, weights)));
      }
    });
  }

  [[nodiscard]] static double LongestOf(const LightMesh& mesh,
                                        const PlanTriangle& triangle) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t corner) {
        return mesh.vertices[static_cast<std::size_t>(triangle.corners[corner])]
            .at;
      };
      longest = std::max(longest, LengthOf(at(k) - at((k + 1) % 3)));
    }
    return longest;
  }

  /// Makes the uniform mesh and measures it.
  void Compare(std::span<const LitPoint> sample, SideMesh& result) {
    const EdgePlan outline = OutlinePlan(scene_, side_, wishes_.tolerances);
    const auto is_inside = [&](const PlanPoint& p) { return IsOnSurface(p); };
    const auto wanted = static_cast<double>(result.mesh.vertices.size());
    // As many vertices as squares of the length.
    double length = side_.first().scale.size / std::sqrt(wanted);
    constexpr int kMostTries = 6;
    for (int i = 0; i < kMostTries; ++i) {
      RefinedPlane plane(outline, is_inside);
      plane.DivideTo(length, watch_.stop);
      const auto count = static_cast<double>(plane.point_count());
      if (std::fabs(count / wanted - 1) > 0.02 && i + 1 < kMostTries) {
        length *= std::sqrt(count / wanted);
        continue;
      }
      const LightMesh mesh = Lit(plane.Mesh());
      result.uniform_vertices = plane.point_count();
      result.uniform =
          ErrorOf(side_.probe(), plane, mesh, sample, threads_, watch_);
      return;
    }
  }

  const Scene& scene_;
  const SideSearch& side_;
  const MeshWishes& wishes_;
  int threads_;
  const Watch& watch_;
  KnownValues known_;
};

}  // namespace

SideMesh SideMeshOf(const Scene& scene, const SideSearch& side,
                    std::span<const ContourLine> contours,
                    const MeshWishes& wishes, int threads, const Watch& watch) {
  return MeshMaker(scene, side, wishes, threads, watch).Make(contours);
}

}  // namespace truelux
