// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/light_mesh.h"

#include <cstddef>
#include <utility>

#include "isolux/cut_mesh.h"
#include "isolux/mesh_search.h"
#include "run/parallel.h"
#include "run/progress.h"

namespace truelux {
namespace {

class Lighter {
 public:
  Lighter(const LightProbe& probe, const SharedMesh& mesh, double margin,
          KnownValues& known, int threads, const Watch& watch)
      : probe_(probe),
        shared_(mesh),
        margin_(margin),
        known_(known),
        threads_(threads),
        watch_(watch) {}

  LightMesh Light(double tolerance) {
    CutMesh cut = CutApart(shared_.points, shared_.triangles);
    MoveInwards(margin_, cut);
    for (std::size_t i = 0; i < cut.points.size(); ++i) {
      const int origin = cut.origins[i];
      mesh_.vertices.push_back(
          {shared_.points[static_cast<std::size_t>(origin)], cut.points[i], 0,
           origin});
    }
    mesh_.triangles = std::move(cut.triangles);
    AskAll();
    DivideFeet(tolerance);
    return std::move(mesh_);
  }

 private:
  void AskAll() {
    std::vector<LightVertex*> open;
    for (LightVertex& vertex : mesh_.vertices) {
      const auto entry = known_.find({vertex.receiver.s, vertex.receiver.t});
      if (entry != known_.end()) {
        vertex.value = entry->second;
      } else {
        open.push_back(&vertex);
      }
    }
    Progress progress(open.size(), "vertices", watch_);
    ForEachInParallel(open.size(), threads_, progress, [&](std::size_t i) {
      open[i]->value = probe_.ValueAt(open[i]->receiver).value;
    });
    for (const LightVertex* vertex : open)
      known_[{vertex->receiver.s, vertex->receiver.t}] = vertex->value;
  }

  /// The points where a jump ends or turns.
  [[nodiscard]] std::vector<bool> Feet() const {
    std::vector<PlanPoint> ways(mesh_.vertices.size());
    std::vector<int> counts(mesh_.vertices.size(), 0);
    for (const PlanTriangle& triangle : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.kinds[k] != SideKind::kJump) continue;
        const auto p = static_cast<std::size_t>(triangle.corners[(k + 1) % 3]);
        const auto q = static_cast<std::size_t>(triangle.corners[(k + 2) % 3]);
        const PlanPoint way = mesh_.vertices[q].at - mesh_.vertices[p].at;
        const PlanPoint unit = (1 / LengthOf(way)) * way;
        ways[p] = ways[p] + unit;
        ways[q] = ways[q] - unit;
        ++counts[p];
        ++counts[q];
      }
    }
    // Along a straight jump the two directions cancel but for rounding.
    std::vector<bool> feet(mesh_.vertices.size());
    for (std::size_t i = 0; i < feet.size(); ++i)
      feet[i] = counts[i] > 0 && LengthOf(ways[i]) > 0x1p-20;
    return feet;
  }

  /// A corner at a foot, with a vertex of its own.
  struct FootCorner {
    std::size_t triangle;
    std::size_t k;
    std::size_t foot;  ///< the vertex that all share
    std::size_t own;
  };

  /// Gives each triangle at a foot a vertex of its own, where that matters.
  void DivideFeet(double tolerance) {
    const std::vector<FootCorner> corners = AddFootVertices();
    if (corners.empty()) return;
    AskAll();
    std::vector<ValueRange> ranges(mesh_.vertices.size());
    for (const FootCorner& corner : corners)
      ranges[corner.foot].Take(mesh_.vertices[corner.own].value);
    std::vector<bool> is_used(mesh_.vertices.size(), true);
    for (const FootCorner& corner : corners) {
      const ValueRange& range = ranges[corner.foot];
      const bool is_divided = range.most - range.least > tolerance;
      is_used[is_divided ? corner.foot : corner.own] = false;
      if (is_divided) {
        mesh_.triangles[corner.triangle].corners[corner.k] =
            static_cast<int>(corner.own);
      }
    }
    DropUnused(is_used);
  }

  std::vector<FootCorner> AddFootVertices() {
    const std::vector<bool> feet = Feet();
    std::vector<FootCorner> corners;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto foot =
            static_cast<std::size_t>(mesh_.triangles[i].corners[k]);
        if (!feet[foot]) continue;
        LightVertex own = mesh_.vertices[foot];
        own.receiver = own.at + ReachInto(mesh_.triangles[i], k);
        corners.push_back({i, k, foot, mesh_.vertices.size()});
        mesh_.vertices.push_back(own);
      }
    }
    return corners;
  }

  /// From a corner, in a direction between its sides.
  [[nodiscard]] PlanPoint ReachInto(const PlanTriangle& triangle,
                                    std::size_t k) const {
    const auto at = [&](std::size_t corner) {
      return mesh_
          .vertices[static_cast<std::size_t>(triangle.corners[corner % 3])]
          .at;
    };
    const PlanPoint p = at(k + 1) - at(k);
    const PlanPoint q = at(k + 2) - at(k);
    const PlanPoint between = (1 / LengthOf(p)) * p + (1 / LengthOf(q)) * q;
    // Farther than the margin, so that also in a narrow triangle the receiver is
    // about the margin away from both sides.
    constexpr double kReach = 16;
    return (kReach * margin_ / LengthOf(between)) * between;
  }

  void DropUnused(const std::vector<bool>& is_used) {
    std::vector<int> names(mesh_.vertices.size(), -1);
    std::vector<LightVertex> kept;
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
      if (!is_used[i]) continue;
      names[i] = static_cast<int>(kept.size());
      kept.push_back(mesh_.vertices[i]);
    }
    mesh_.vertices = std::move(kept);
    for (PlanTriangle& triangle : mesh_.triangles) {
      for (int& corner : triangle.corners)
        corner = names[static_cast<std::size_t>(corner)];
    }
  }

  const LightProbe& probe_;
  const SharedMesh& shared_;
  double margin_;
  KnownValues& known_;
  int threads_;
  const Watch& watch_;
  LightMesh mesh_;
};

}  // namespace

double LightMesh::ValueIn(const PlanTriangle& triangle,
                          const std::array<double, 3>& weights) const {
  double value = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    value += weights[k] *
             vertices[static_cast<std::size_t>(triangle.corners[k])].value;
  }
  return value;
}

PlanPoint LightMesh::PointIn(const PlanTriangle& triangle,
                             const std::array<double, 3>& weights) const {
  PlanPoint point;
  for (std::size_t k = 0; k < 3; ++k) {
    point =
        point +
        weights[k] * vertices[static_cast<std::size_t>(triangle.corners[k])].at;
  }
  return point;
}

LightMesh LightMeshOf(const LightProbe& probe, const SharedMesh& mesh,
                      double margin, double tolerance, KnownValues& known,
                      int threads, const Watch& watch) {
  return Lighter(probe, mesh, margin, known, threads, watch).Light(tolerance);
}

}  // namespace truelux
