// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles over a flat surface, to be halved where something is unknown.

#ifndef TRUELUX_ISOLUX_PLAN_MESH_H_
#define TRUELUX_ISOLUX_PLAN_MESH_H_

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "isolux/plan_frame.h"

namespace truelux {

/// What a side of a triangle lies on.
enum class SideKind : unsigned char {
  kInner,    ///< nothing
  kKink,     ///< a line across which the gradient may jump
  kJump,     ///< a face that stands on the surface; no neighbour there
  kOutline,  ///< the surface's outline, likewise
};

/// A triangle whose corners run counter-clockwise. Side k is opposite to corner
/// k, from corner k + 1 to corner k + 2.
struct PlanTriangle {
  std::array<int, 3> corners{};    ///< indices into PlanMesh::points()
  std::array<int, 3> neighbors{};  ///< triangles; -1: none
  std::array<SideKind, 3> kinds{};
  /// Of which line of the first mesh they are parts, as its maker counts; -1: of
  /// none.
  std::array<int, 3> seams{-1, -1, -1};
};

/// Triangles that fill a surface side by side, corner to corner.
class PlanMesh {
 public:
  /// triangles: with their neighbours.
  PlanMesh(std::vector<PlanPoint> points, std::vector<PlanTriangle> triangles)
      : points_(std::move(points)), triangles_(std::move(triangles)) {}

  [[nodiscard]] const std::vector<PlanPoint>& points() const { return points_; }

  [[nodiscard]] const std::vector<PlanTriangle>& triangles() const {
    return triangles_;
  }

  [[nodiscard]] const PlanTriangle& At(int triangle) const {
    return triangles_[static_cast<std::size_t>(triangle)];
  }

  [[nodiscard]] std::array<PlanPoint, 3> CornersOf(int triangle) const;

  /// A point near the middle.
  [[nodiscard]] PlanPoint CentreOf(int triangle) const;

  [[nodiscard]] double LongestSideOf(int triangle) const;

  [[nodiscard]] double AreaOf(int triangle) const;

  /// Whether a point is in a triangle or on its sides, within rounding.
  [[nodiscard]] bool Holds(int triangle, const PlanPoint& p) const;

  /// Halves a triangle across its longest side, and others before it until
  /// their sides match (Rivara 1984): angles stay above half of the least there
  /// was. Calls changed(i, j) for each triangle i that became i and a new j.
  void Halve(int triangle, const std::function<void(int, int)>& changed);

 private:
  [[nodiscard]] std::size_t LongestOf(const PlanTriangle& triangle) const;
  [[nodiscard]] int SideTowards(int triangle, int neighbor) const;
  int SplitAt(int triangle, std::size_t side, int point,
              const std::function<void(int, int)>& changed);

  std::vector<PlanPoint> points_;
  std::vector<PlanTriangle> triangles_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_PLAN_MESH_H_
