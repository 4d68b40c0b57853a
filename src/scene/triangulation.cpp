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

/// The points that are left, and which of them are tips of ears.
class EarClipper {
 public:
  explicit EarClipper(const ProjectedRing& ring) : ring_(ring) {
    const auto n = static_cast<std::size_t>(ring.size());
    points_.resize(n);
    is_ear_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      points_[i] = static_cast<int>(i);
    for (std::size_t i = 0; i < n; ++i)
      is_ear_[i] = IsEar(i);
  }

  void Run(std::vector<RingTriangle>& triangles) {
    while (points_.size() > 3) {
      const std::size_t tip = FirstEar();
      triangles.push_back(TriangleAt(tip));
      Remove(tip);
    }
    triangles.push_back({points_[2], points_[0], points_[1]});
  }

 private:
  [[nodiscard]] std::size_t Next(std::size_t i) const {
    return i + 1 < points_.size() ? i + 1 : 0;
  }

  [[nodiscard]] std::size_t Previous(std::size_t i) const {
    return (i > 0 ? i : points_.size()) - 1;
  }

  [[nodiscard]] RingTriangle TriangleAt(std::size_t tip) const {
    return {points_[Previous(tip)], points_[tip], points_[Next(tip)]};
  }

  [[nodiscard]] bool IsEar(std::size_t tip) const {
    const RingTriangle triangle = TriangleAt(tip);
    if (!IsPositive(ring_, triangle)) return false;
    for (const int point : points_) {
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
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(tip));
    is_ear_.erase(is_ear_.begin() + static_cast<std::ptrdiff_t>(tip));
    const std::size_t next = tip < points_.size() ? tip : 0;
    is_ear_[next] = IsEar(next);
    is_ear_[Previous(next)] = IsEar(Previous(next));
  }

  const ProjectedRing& ring_;
  std::vector<int> points_;
  std::vector<bool> is_ear_;
};

/// Clips ears off a ring that meets itself.
class MeetingClipper {
 public:
  explicit MeetingClipper(const ProjectedRing& ring)
      : ring_(ring), points_(static_cast<std::size_t>(ring.size())) {
    std::iota(points_.begin(), points_.end(), 0);
  }

  /// False if there is no ear.
  bool Run(std::vector<RingTriangle>& triangles) {
    while (points_.size() >= 3) {
      std::size_t tip = 0;
      while (tip < points_.size() && !IsEar(tip))
        ++tip;
      if (tip == points_.size()) return false;
      triangles.push_back(TriangleAt(tip));
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(tip));
      RemoveSpikes(points_, [this](int i, int j) { return Coincide(i, j); });
    }
    return true;
  }

 private:
  [[nodiscard]] int After(std::size_t i) const {
    return points_[i + 1 < points_.size() ? i + 1 : 0];
  }

  [[nodiscard]] int Before(std::size_t i) const {
    return points_[(i > 0 ? i : points_.size()) - 1];
  }

  [[nodiscard]] RingTriangle TriangleAt(std::size_t tip) const {
    return {Before(tip), points_[tip], After(tip)};
  }

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
    const RingTriangle t = TriangleAt(tip);
    if (!IsPositive(ring_, t)) return false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i == tip) continue;
      const int point = points_[i];
      if (Coincide(point, t[1])) {
        if (IsBetweenSides(t, Before(i)) || IsBetweenSides(t, After(i))) {
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
  std::vector<int> points_;
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
