// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/plan_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace truelux {

std::array<PlanPoint, 3> PlanMesh::CornersOf(int triangle) const {
  std::array<PlanPoint, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = points_[static_cast<std::size_t>(At(triangle).corners[k])];
  }
  return corners;
}

PlanPoint PlanMesh::CentreOf(int triangle) const {
  const auto [a, b, c] = CornersOf(triangle);
  // In a regular scene the middle itself often lies in a plane of two edges,
  // where derivatives cost a hundred times as much.
  return 0.3303 * a + 0.3361 * b + 0.3336 * c;
}

double PlanMesh::LongestSideOf(int triangle) const {
  const auto [a, b, c] = CornersOf(triangle);
  return std::max({LengthOf(b - a), LengthOf(c - b), LengthOf(a - c)});
}

double PlanMesh::AreaOf(int triangle) const {
  const auto [a, b, c] = CornersOf(triangle);
  return Cross(b - a, c - a) / 2;
}

std::size_t PlanMesh::LongestOf(const PlanTriangle& triangle) const {
  // Equal lengths are told apart by their ends, so that both triangles of a
  // side choose alike.
  std::size_t longest = 0;
  double most = -1;
  std::pair<int, int> name;
  for (std::size_t k = 0; k < 3; ++k) {
    const int p = triangle.corners[(k + 1) % 3];
    const int q = triangle.corners[(k + 2) % 3];
    const PlanPoint way = points_[static_cast<std::size_t>(std::max(p, q))] -
                          points_[static_cast<std::size_t>(std::min(p, q))];
    const double square = Dot(way, way);
    const std::pair<int, int> ends = std::minmax(p, q);
    if (square > most || (square == most && ends < name)) {
      longest = k;
      most = square;
      name = ends;
    }
  }
  return longest;
}

bool PlanMesh::Holds(int triangle, const PlanPoint& p) const {
  const auto c = CornersOf(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    if (Cross(c[(k + 1) % 3] - c[k], p - c[k]) < 0) return false;
  }
  return true;
}

int PlanMesh::SideTowards(int triangle, int neighbor) const {
  const auto& neighbors = At(triangle).neighbors;
  for (int k = 0; k < 3; ++k) {
    if (neighbors[static_cast<std::size_t>(k)] == neighbor) return k;
  }
  return -1;
}

int PlanMesh::SplitAt(int triangle, std::size_t side, int point,
                      const std::function<void(int, int)>& changed) {
  // Corner `side` is a; the side is b c. The triangle becomes a b point, the
  // new one a point c.
  const auto added = static_cast<int>(triangles_.size());
  const PlanTriangle old = At(triangle);
  const std::size_t b = (side + 1) % 3;
  const std::size_t c = (side + 2) % 3;
  PlanTriangle near = old;
  near.corners[c] = point;
  near.neighbors[b] = added;
  near.kinds[b] = SideKind::kInner;
  near.seams[b] = -1;
  PlanTriangle far = old;
  far.corners[b] = point;
  far.neighbors[c] = triangle;
  far.kinds[c] = SideKind::kInner;
  far.seams[c] = -1;
  triangles_[static_cast<std::size_t>(triangle)] = near;
  triangles_.push_back(far);
  if (const int beyond = old.neighbors[b]; beyond >= 0) {
    const int back = SideTowards(beyond, triangle);
    triangles_[static_cast<std::size_t>(beyond)]
        .neighbors[static_cast<std::size_t>(back)] = added;
  }
  changed(triangle, added);
  return added;
}

void PlanMesh::Halve(int triangle,
                     const std::function<void(int, int)>& changed) {
  // The longest side of each is at least as long as that of the one before, so
  // that the way ends.
  std::vector<int> way = {triangle};
  while (!way.empty()) {
    const int first = way.back();
    const std::size_t side = LongestOf(At(first));
    const int other = At(first).neighbors[side];
    if (other >= 0) {
      const std::size_t back = LongestOf(At(other));
      if (At(other).neighbors[back] != first) {
        way.push_back(other);
        continue;
      }
    }
    way.pop_back();
    const int p = At(first).corners[(side + 1) % 3];
    const int q = At(first).corners[(side + 2) % 3];
    const auto point = static_cast<int>(points_.size());
    points_.push_back(0.5 * (points_[static_cast<std::size_t>(p)] +
                             points_[static_cast<std::size_t>(q)]));
    const std::size_t back = other >= 0 ? LongestOf(At(other)) : 0;
    const int beside_q = SplitAt(first, side, point, changed);
    if (other < 0) continue;
    // Its side runs from q to p: the old part is at q, the new one at p.
    const int beside_p = SplitAt(other, back, point, changed);
    triangles_[static_cast<std::size_t>(first)].neighbors[side] = beside_p;
    triangles_[static_cast<std::size_t>(beside_p)].neighbors[back] = first;
    triangles_[static_cast<std::size_t>(beside_q)].neighbors[side] = other;
    triangles_[static_cast<std::size_t>(other)].neighbors[back] = beside_q;
  }
}

}  // namespace truelux
