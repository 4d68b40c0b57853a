// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/iso_mesh_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "isolux/isolux_run.h"
#include "isomesh/side_mesh.h"
#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

/// Where nothing is asked for.
constexpr double kError = 1.0 / 100;
constexpr double kSmallest = 0x1p-12;
constexpr double kCorner = 0x1p-16;
constexpr double kChord = 0x1p-11;
constexpr std::size_t kMostVertices = 300'000;

void CheckNumber(const char* name, double value) {
  if (value >= 0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format(
      "{}: {} is not a number that is 0 or more (0 chooses one)", name, value));
}

MeshSide SideOf(const PlanTriangle& triangle, std::size_t k) {
  switch (triangle.kinds[k]) {
    case SideKind::kInner:
      return triangle.seams[k] >= 0 ? MeshSide::kContour : MeshSide::kInside;
    case SideKind::kKink:
      return MeshSide::kKink;
    case SideKind::kJump:
      return MeshSide::kJump;
    case SideKind::kOutline:
      break;
  }
  return MeshSide::kOutline;
}

double LeastAngleOf(const LightMesh& mesh, const PlanTriangle& triangle) {
  double least = std::numbers::pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t corner) {
      return mesh
          .vertices[static_cast<std::size_t>(triangle.corners[corner % 3])]
          .at;
    };
    const PlanPoint u = at(k + 1) - at(k);
    const PlanPoint v = at(k + 2) - at(k);
    least = std::min(least, std::atan2(Cross(u, v), Dot(u, v)));
  }
  // Of a sliver within rounding the sign means nothing.
  return std::max(0.0, least) * 180 / std::numbers::pi;
}

/// The larger ones.
void Join(const InterpolationError& one, InterpolationError& sum) {
  sum.most = std::max(sum.most, one.most);
  sum.at_99 = std::max(sum.at_99, one.at_99);
  sum.mean = std::max(sum.mean, one.mean);
}

class IsoMeshFinder {
 public:
  IsoMeshFinder(const Oracle& oracle, const IsoMeshOptions& options,
                const Watch& watch)
      : oracle_(oracle), options_(options), watch_(watch) {}

  IsoMesh Find(const std::string& surface) {
    TracedSurface traced =
        TraceSurface(oracle_, surface, options_.contours, watch_);
    mesh_.isolux = std::move(traced.isolux);
    const Isolux& isolux = mesh_.isolux;
    MeshWishes wishes;
    wishes.error = options_.error > 0 ? options_.error
                                      : kError * (isolux.most - isolux.least);
    wishes.smallest =
        options_.smallest > 0 ? options_.smallest : kSmallest * isolux.size;
    wishes.tolerances.corner = kCorner * isolux.size;
    wishes.tolerances.chord = kChord * isolux.size;
    wishes.most_vertices =
        options_.most_vertices > 0 ? options_.most_vertices : kMostVertices;
    mesh_.error = wishes.error;
    mesh_.least_angle = 180;  // of no triangle
    for (std::size_t i = 0; i < traced.lines.size(); ++i) {
      const SideSearch& side = *traced.prepared.sides[i];
      const std::uint64_t before = side.probe().count();
      Add(side, SideMeshOf(oracle_.scene(), side, traced.lines[i], wishes,
                           options_.contours.threads, watch_));
      mesh_.evaluations += side.probe().count() - before;
    }
    return std::move(mesh_);
  }

 private:
  void Add(const SideSearch& side, const SideMesh& part) {
    const auto first = static_cast<int>(mesh_.vertices.size());
    AddVertices(side.plan(), part.mesh);
    const int face = side.plan().ReceiverAt({}).on_face;
    for (const PlanTriangle& triangle : part.mesh.triangles) {
      IsoMeshTriangle& added = mesh_.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        added.vertices[k] = first + triangle.corners[k];
        added.sides[k] = SideOf(triangle, k);
      }
      added.face = face;
      mesh_.least_angle =
          std::min(mesh_.least_angle, LeastAngleOf(part.mesh, triangle));
    }
    mesh_.unfinished += part.unfinished;
    mesh_.uniform_vertices += part.uniform_vertices;
    Join(part.interpolation, mesh_.interpolation);
    Join(part.uniform, mesh_.uniform);
    mesh_.drawn += part.plan.drawn;
    mesh_.most_drawn = std::max(mesh_.most_drawn, part.plan.most_drawn);
  }

  void AddVertices(const PlanFrame& plan, const LightMesh& mesh) {
    std::vector<Receiver> receivers;
    for (const LightVertex& vertex : mesh.vertices)
      receivers.push_back(plan.ReceiverAt(vertex.receiver));
    const std::size_t first = mesh_.vertices.size();
    mesh_.vertices.resize(first + receivers.size());
    mesh_.evaluations += receivers.size();
    Progress progress(receivers.size(), "vertices", watch_);
    EvaluateInParallel(oracle_, receivers, options_.contours.threads, progress,
                       [&](std::size_t i, const Irradiance& irradiance) {
                         IsoMeshVertex& vertex = mesh_.vertices[first + i];
                         vertex.at = plan.PointAt(mesh.vertices[i].at);
                         vertex.irradiance = irradiance.value;
                         vertex.value = mesh.vertices[i].value;
                       });
  }

  const Oracle& oracle_;
  const IsoMeshOptions& options_;
  const Watch& watch_;
  IsoMesh mesh_;
};

}  // namespace

IsoMesh FindIsoMesh(const Oracle& oracle, const std::string& surface,
                    const IsoMeshOptions& options, const Watch& watch) {
  CheckNumber("error", options.error);
  CheckNumber("smallest", options.smallest);
  return IsoMeshFinder(oracle, options, watch).Find(surface);
}

}  // namespace truelux
