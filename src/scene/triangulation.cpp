// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/triangulation.h"

#include <cassert>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "exact/rounding.h"
#include "exact/sign.h"
#include "scene/ring_spikes.h"
#include "scene/simple_polygon.h"

namespace truelux {
namespace {

bool IsPositive(const ProjectedRing& ring, const RingTriangle& t) {
  return ring.Orientation(t[0], t[1], t[2]) == Sign::kPositive;
}

/// Whether a point lies in a triangle or on its border.
bool IsIn(const ProjectedRing& ring, const RingTriangle& t, int point) {
  return ring.Orientation(t[0], t[1], point) != Sign::kNegative &&
         ring.Orientation(t[1], t[2], point) != Sign::kNegative &&
         ring.Orientation(t[2], t[0], point) != Sign::kNegative;
}

/// Appends the fan from point 0. Returns false if it has a triangle without
/// positive area.
bool TryFan(const ProjectedRing& ring, std::vector<RingTriangle>& triangles) {
  for (int i = 1; i + 1 < ring.size(); ++i) {
    const RingTriangle triangle{0, i, i + 1};
    if (!IsPositive(ring, triangle)) return false;
    triangles.push_back(triangle);
  }
  return true;
}

/// The points of a ring from which ears are clipped, as far as they are left.
class PointsLeft {
 public:
  explicit PointsLeft(const ProjectedRing& ring)
      : points_(static_cast<std::size_t>(ring.size())) {
    std::iota(points_.begin(), points_.end(), 0);
  }

  [[nodiscard]] std::size_t size() const { return points_.size(); }

  /// Their indices, in ring order.
  std::vector<int>& points() { return points_; }

  [[nodiscard]] const std::vector<int>& points() const { return points_; }

  [[nodiscard]] std::size_t Next(std::size_t i) const {
    return i + 1 < points_.size() ? i + 1 : 0;
  }

  [[nodiscard]] std::size_t Previous(std::size_t i) const {
    return (i > 0 ? i : points_.size()) - 1;
  }

  [[nodiscard]] int After(std::size_t i) const { return points_[Next(i)]; }

  [[nodiscard]] int Before(std::size_t i) const { return points_[Previous(i)]; }

  [[nodiscard]] RingTriangle TriangleAt(std::size_t tip) const {
    return {Before(tip), points_[tip], After(tip)};
  }

  void Remove(std::size_t tip) {
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(tip));
  }

 private:
  std::vector<int> points_;
};

/// Clips ears off a simple ring; knows which of the points are tips of ears.
class EarClipper {
 public:
  explicit EarClipper(const ProjectedRing& ring)
      : ring_(ring), left_(ring), is_ear_(left_.size()) {
    for (std::size_t i = 0; i < is_ear_.size(); ++i)
      is_ear_[i] = IsEar(i);
  }

  void Run(std::vector<RingTriangle>& triangles) {
    while (left_.size() > 3) {
      const std::size_t tip = FirstEar();
      triangles.push_back(left_.TriangleAt(tip));
      Remove(tip);
    }
    triangles.push_back(left_.TriangleAt(0));
  }

 private:
  [[nodiscard]] bool IsEar(std::size_t tip) const {
    const RingTriangle triangle = left_.TriangleAt(tip);
    if (!IsPositive(ring_, triangle)) return false;
    for (const int point : left_.points()) {
      if (point != triangle[0] && point != triangle[1] &&
          point != triangle[2] && IsIn(ring_, triangle, point)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] std::size_t FirstEar() const {
    for (std::size_t i = 0; i < is_ear_.size(); ++i) {
      if (is_ear_[i]) return i;
    }
    throw std::logic_error("a simple polygon has no ear");
  }

  /// Only the neighbours can become or cease to be ears: of the points in the
  /// triangle of a convex point, the one farthest from the triangle's base is
  /// not convex, so it is no tip and stays, and with it the verdict.
  void Remove(std::size_t tip) {
    left_.Remove(tip);
    is_ear_.erase(is_ear_.begin() + static_cast<std::ptrdiff_t>(tip));
    const std::size_t next = tip < left_.size() ? tip : 0;
    const std::size_t previous = left_.Previous(next);
    is_ear_[next] = IsEar(next);
    is_ear_[previous] = IsEar(previous);
  }

  const ProjectedRing& ring_;
  PointsLeft left_;
  std::vector<bool> is_ear_;
};

/// Clips ears off a ring that meets itself.
class MeetingClipper {
 public:
  explicit MeetingClipper(const ProjectedRing& ring)
      : ring_(ring), left_(ring) {}

  /// False if there is no ear.
  bool Run(std::vector<RingTriangle>& triangles) {
    while (left_.size() >= 3) {
      std::size_t tip = 0;
      while (tip < left_.size() && !IsEar(tip))
        ++tip;
      if (tip == left_.size()) return false;
      triangles.push_back(left_.TriangleAt(tip));
      left_.Remove(tip);
      RemoveSpikes(left_.points(),
                   [this](int i, int j) { return Coincide(i, j); });
    }
    return true;
  }

 private:
  [[nodiscard]] bool Coincide(int i, int j) const {
    return i == j || ring_.Order(i, j) == Sign::kZero;
  }

  [[nodiscard]] bool IsLeft(int i, int j, int k) const {
    return ring_.Orientation(i, j, k) == Sign::kPositive;
  }

  /// Whether a point lies strictly between the sides of an ear, seen from its
  /// tip.
  [[nodiscard]] bool IsBetweenSides(const RingTriangle& t, int point) const {
    return IsLeft(t[0], t[1], point) && IsLeft(t[1], t[2], point);
  }

  [[nodiscard]] bool IsEar(std::size_t tip) const {
    const RingTriangle t = left_.TriangleAt(tip);
    if (!IsPositive(ring_, t)) return false;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (i == tip) continue;
      const int point = left_.points()[i];
      if (Coincide(point, t[1])) {
        if (IsBetweenSides(t, left_.Before(i)) ||
            IsBetweenSides(t, left_.After(i))) {
          return false;
        }
      } else if (!Coincide(point, t[0]) && !Coincide(point, t[2]) &&
                 IsIn(ring_, t, point)) {
        return false;
      }
    }
    return true;
  }

  const ProjectedRing& ring_;
  PointsLeft left_;
};

}  // namespace

void Triangulate(const ProjectedRing& ring,
                 std::vector<RingTriangle>& triangles) {
  assert(IsRoundingUpward());
  assert(!FindContact(ring));
  triangles.clear();
  if (TryFan(ring, triangles)) return;
  triangles.clear();
  EarClipper(ring).Run(triangles);
}

void TriangulateMeetingItself(const ProjectedRing& ring,
                              std::vector<RingTriangle>& triangles) {
  assert(IsRoundingUpward());
  triangles.clear();
  if (TryFan(ring, triangles)) return;
  triangles.clear();
  if (!MeetingClipper(ring).Run(triangles)) triangles.clear();
}

}  // namespace truelux
