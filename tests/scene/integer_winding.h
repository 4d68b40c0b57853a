// SPDX-License-Identifier: GPL-3.0-or-later
// Winding numbers of small rings of integers, in the plainest way: the image is
// cut into vertical slabs in which no two edges cross, and each slab is walked
// through from below.

#ifndef TRUELUX_TESTS_SCENE_INTEGER_WINDING_H_
#define TRUELUX_TESTS_SCENE_INTEGER_WINDING_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "scene/integer_ring.h"

namespace truelux {

/// A point of the image, exactly.
struct RationalPoint {
  mpq_class x;
  mpq_class y;
};

/// A point off the ring and how often the ring winds around it.
struct Witness {
  RationalPoint point;
  int winding = 0;
};

/// The ring as seen along a normal, which is not zero: counter-clockwise stays
/// so.
inline std::vector<RationalPoint> ImageOf(const IntegerRing& ring,
                                          const IntegerPoint& n) {
  std::vector<RationalPoint> image;
  // Through a text: GMP knows no integer of 64 bits by that name.
  const auto exact = [](Integer value) {
    return mpq_class(std::to_string(value));
  };
  for (const IntegerPoint& p : ring.points) {
    IntegerPoint q = p;
    IntegerPoint m = n;
    while (m.z == 0) {
      q = {q.y, q.z, q.x};
      m = {m.y, m.z, m.x};
    }
    const Integer sign = m.z < 0 ? -1 : 1;
    const Integer u = sign * (m.z * q.x - m.x * q.z);
    const Integer v = sign * (m.z * q.y - m.y * q.z);
    image.push_back({exact(u), exact(v)});
    // Both axes were turned: the sense is that of m.z.
    if (m.z < 0) std::swap(image.back().x, image.back().y);
  }
  return image;
}

/// A point in the middle of every gap of every slab.
inline std::vector<Witness> WitnessesOf(
    const std::vector<RationalPoint>& image) {
  const std::size_t n = image.size();
  const auto at = [&](std::size_t i) -> const RationalPoint& {
    return image[i % n];
  };
  std::vector<mpq_class> cuts;
  for (std::size_t i = 0; i < n; ++i) {
    cuts.push_back(at(i).x);
    for (std::size_t k = i + 1; k < n; ++k) {
      const mpq_class ax = at(i + 1).x - at(i).x;
      const mpq_class ay = at(i + 1).y - at(i).y;
      const mpq_class bx = at(k + 1).x - at(k).x;
      const mpq_class by = at(k + 1).y - at(k).y;
      const mpq_class cross = ax * by - ay * bx;
      if (cross == 0) continue;
      const mpq_class t =
          ((at(k).x - at(i).x) * by - (at(k).y - at(i).y) * bx) / cross;
      cuts.push_back(at(i).x + t * ax);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<Witness> witnesses;
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
    const mpq_class x = (cuts[c] + cuts[c + 1]) / 2;
    std::vector<std::pair<mpq_class, int>> edges;  // height, step upwards
    for (std::size_t i = 0; i < n; ++i) {
      const RationalPoint& a = at(i);
      const RationalPoint& b = at(i + 1);
      if ((a.x < x) == (b.x < x)) continue;
      edges.emplace_back(a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x),
                         a.x < b.x ? 1 : -1);
    }
    std::sort(edges.begin(), edges.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      winding += edges[i].second;
      if (edges[i].first == edges[i + 1].first) continue;
      witnesses.push_back(
          {{x, (edges[i].first + edges[i + 1].first) / 2}, winding});
    }
  }
  return witnesses;
}

/// Twice the area of a triangle of the image.
inline mpq_class TurnOf(const RationalPoint& a, const RationalPoint& b,
                        const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How many triangles of corners of the image contain a point; nothing if it
/// lies on an edge of one.
inline std::optional<int> CoverCount(
    const std::vector<RationalPoint>& image,
    const std::vector<std::array<int, 3>>& triangles, const RationalPoint& p) {
  const auto at = [&](int i) { return image[static_cast<std::size_t>(i)]; };
  int count = 0;
  for (const auto& [a, b, c] : triangles) {
    const std::array<mpq_class, 3> turns{TurnOf(at(a), at(b), p),
                                         TurnOf(at(b), at(c), p),
                                         TurnOf(at(c), at(a), p)};
    const mpq_class& least = *std::min_element(turns.begin(), turns.end());
    if (least == 0) return std::nullopt;
    if (least > 0) ++count;
  }
  return count;
}

}  // namespace truelux

#endif  // TRUELUX_TESTS_SCENE_INTEGER_WINDING_H_
