// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/cut_mesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace truelux {
namespace {

class Cutter {
 public:
  Cutter(std::span<const PlanPoint> points, std::vector<PlanTriangle> triangles)
      : points_(points), old_(triangles) {
    mesh_.triangles = std::move(triangles);
  }

  CutMesh Cut() {
    for (PlanTriangle& triangle : mesh_.triangles)
      triangle.corners = {-1, -1, -1};
    for (std::size_t i = 0; i < old_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh_.triangles[i].corners[k] >= 0) continue;
        const int origin = old_[i].corners[k];
        const auto name = static_cast<int>(mesh_.points.size());
        mesh_.points.push_back(points_[static_cast<std::size_t>(origin)]);
        mesh_.origins.push_back(origin);
        NameCorner(static_cast<int>(i), origin, name);
      }
    }
    return std::move(mesh_);
  }

 private:
  void NameCorner(int triangle, int origin, int name) {
    std::vector<int> open = {triangle};
    while (!open.empty()) {
      const auto next = static_cast<std::size_t>(open.back());
      open.pop_back();
      const auto k = static_cast<std::size_t>(
          std::ranges::find(old_[next].corners, origin) -
          old_[next].corners.begin());
      PlanTriangle& t = mesh_.triangles[next];
      if (t.corners[k] >= 0) continue;
      t.corners[k] = name;
      for (const std::size_t side : {(k + 1) % 3, (k + 2) % 3}) {
        if (t.neighbors[side] >= 0) open.push_back(t.neighbors[side]);
      }
    }
  }

  std::span<const PlanPoint> points_;
  std::vector<PlanTriangle> old_;
  CutMesh mesh_;
};

/// What the cut sides at a point say.
struct CutSides {
  std::size_t count = 0;
  PlanPoint inward;  ///< sum of the unit normals
  PlanPoint onward;  ///< sum of the directions from their other ends
};

}  // namespace

CutMesh CutApart(std::span<const PlanPoint> points,
                 std::vector<PlanTriangle> triangles) {
  return Cutter(points, std::move(triangles)).Cut();
}

void MoveInwards(double margin, CutMesh& mesh) {
  std::vector<CutSides> sides(mesh.points.size());
  for (const PlanTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.neighbors[k] >= 0) continue;
      const auto p = static_cast<std::size_t>(triangle.corners[(k + 1) % 3]);
      const auto q = static_cast<std::size_t>(triangle.corners[(k + 2) % 3]);
      const PlanPoint way = mesh.points[q] - mesh.points[p];
      const double length = LengthOf(way);
      // Lines that are as near as a rounding have corners that are rounded to
      // one place; a side between them has no direction.
      if (length == 0) continue;
      const PlanPoint left = {-way.t / length, way.s / length};
      for (const std::size_t end : {p, q}) {
        ++sides[end].count;
        sides[end].inward = sides[end].inward + left;
      }
      sides[q].onward = sides[q].onward + (1 / length) * way;
      sides[p].onward = sides[p].onward - (1 / length) * way;
    }
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    PlanPoint move = sides[i].inward;
    // At two sides the point that is as far from both; at the end of a jump,
    // where they are opposite, straight on.
    if (sides[i].count == 2) {
      const double square = Dot(move, move);
      if (square < 0x1p-30) {
        const double length = LengthOf(sides[i].onward);
        move = length > 0 ? (1 / length) * sides[i].onward : PlanPoint{};
      } else {
        move = std::min(2 / square, 4.0) * move;
      }
    }
    mesh.points[i] = mesh.points[i] + margin * move;
  }
}

}  // namespace truelux
