// SPDX-License-Identifier: GPL-3.0-or-later
// Rule for rule what src/scene does with rings, on small integers, in the
// slowest and plainest way.

#ifndef TRUELUX_TESTS_SCENE_INTEGER_RING_H_
#define TRUELUX_TESTS_SCENE_INTEGER_RING_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "truelux/geometry.h"

#include "exact/vec3.h"

namespace truelux {

using Integer = std::int64_t;
using IntegerPoint = Vec3<Integer>;

/// Points with coordinates up to about 20 in absolute value.
struct IntegerRing {
  std::vector<IntegerPoint> points;

  [[nodiscard]] std::size_t size() const { return points.size(); }

  [[nodiscard]] const IntegerPoint& At(std::size_t i) const {
    return points[i % points.size()];
  }

  [[nodiscard]] IntegerPoint Normal() const {
    IntegerPoint n{0, 0, 0};
    for (std::size_t i = 0; i < size(); ++i) {
      n = n - Cross(At(i + 1), At(i));
    }
    return n;
  }

  /// N . ((b - a) x (c - a)).
  [[nodiscard]] Integer Turn(std::size_t a, std::size_t b,
                             std::size_t c) const {
    return Determinant(Normal(), At(b) - At(a), At(c) - At(a));
  }

  [[nodiscard]] bool SamePlace(std::size_t a, std::size_t b) const {
    const IntegerPoint d = Cross(At(a) - At(b), Normal());
    return d.x == 0 && d.y == 0 && d.z == 0;
  }

  /// Whether point p lies on the closed segment a-b, seen along the normal.
  [[nodiscard]] bool OnSegment(std::size_t a, std::size_t b,
                               std::size_t p) const {
    if (SamePlace(a, p) || SamePlace(b, p)) return true;
    if (Turn(a, b, p) != 0) return false;
    const IntegerPoint to_a = Cross(At(a) - At(p), Normal());
    const IntegerPoint to_b = Cross(At(b) - At(p), Normal());
    return Dot(to_a, to_b) < 0;
  }

  [[nodiscard]] bool Meet(std::size_t a, std::size_t b, std::size_t c,
                          std::size_t d) const {
    if (OnSegment(a, b, c) || OnSegment(a, b, d) || OnSegment(c, d, a) ||
        OnSegment(c, d, b)) {
      return true;
    }
    const auto opposite = [](Integer s, Integer t) {
      return (s < 0 && t > 0) || (s > 0 && t < 0);
    };
    return opposite(Turn(a, b, c), Turn(a, b, d)) &&
           opposite(Turn(c, d, a), Turn(c, d, b));
  }

  [[nodiscard]] bool IsSimple() const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (SamePlace(i, i + 1) || OnSegment(i, i + 1, i + 2) ||
          OnSegment(i + 1, i + 2, i)) {
        return false;
      }
      for (std::size_t j = i + 2; j < size(); ++j) {
        if ((j + 1) % size() != i && Meet(i, i + 1, j, j + 1)) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool IsPlanar() const {
    for (std::size_t i = 1; i < size(); ++i) {
      if (Dot(Normal(), At(i) - At(0)) != 0) return false;
    }
    return true;
  }

  [[nodiscard]] bool OnOneLine() const {
    for (std::size_t i = 2; i < size(); ++i) {
      const IntegerPoint c = Cross(At(1) - At(0), At(i) - At(0));
      if (c.x != 0 || c.y != 0 || c.z != 0) return false;
    }
    return true;
  }

  /// Fan, else the first ear again and again, word for word.
  [[nodiscard]] std::vector<std::array<int, 3>> Triangles() const {
    std::vector<std::array<int, 3>> fan;
    bool is_fan = true;
    for (std::size_t i = 1; i + 1 < size(); ++i) {
      is_fan = is_fan && Turn(0, i, i + 1) > 0;
      fan.push_back({0, static_cast<int>(i), static_cast<int>(i) + 1});
    }
    return is_fan ? fan : ClippedEars();
  }

  [[nodiscard]] std::vector<Point3> Points() const {
    std::vector<Point3> result;
    for (const IntegerPoint& p : points) {
      result.push_back({static_cast<double>(p.x), static_cast<double>(p.y),
                        static_cast<double>(p.z)});
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<std::array<int, 3>> ClippedEars() const {
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::size_t> left(size());
    for (std::size_t i = 0; i < size(); ++i)
      left[i] = i;
    while (left.size() > 2) {
      std::size_t tip = 0;
      while (tip < left.size() && !IsEar(left, tip))
        ++tip;
      if (tip == left.size()) return {};
      const std::size_t m = left.size();
      triangles.push_back({static_cast<int>(left[(tip + m - 1) % m]),
                           static_cast<int>(left[tip]),
                           static_cast<int>(left[(tip + 1) % m])});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(tip));
    }
    return triangles;
  }

  [[nodiscard]] bool IsEar(const std::vector<std::size_t>& left,
                           std::size_t tip) const {
    const std::size_t m = left.size();
    const std::size_t a = left[(tip + m - 1) % m];
    const std::size_t b = left[tip];
    const std::size_t c = left[(tip + 1) % m];
    if (Turn(a, b, c) <= 0) return false;
    for (const std::size_t p : left) {
      if (p != a && p != b && p != c && Turn(a, b, p) >= 0 &&
          Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }
};

/// n points on a grid of small integers, no two consecutive ones equal; in
/// the plane z = x + 2 y if planar.
inline IntegerRing RandomIntegerRing(std::mt19937_64& random, std::size_t n,
                                     unsigned width, bool planar) {
  const auto draw = [&] { return static_cast<Integer>(random() % width); };
  const auto same = [](const IntegerPoint& a, const IntegerPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  IntegerRing ring;
  while (ring.size() < n) {
    IntegerPoint p{draw(), draw(), draw() % 2};
    if (planar) p.z = p.x + 2 * p.y;
    const bool last = ring.size() + 1 == n;
    if (ring.size() > 0 && (same(p, ring.points.back()) ||
                            (last && same(p, ring.points.front())))) {
      continue;
    }
    ring.points.push_back(p);
  }
  return ring;
}

}  // namespace truelux

#endif  // TRUELUX_TESTS_SCENE_INTEGER_RING_H_
