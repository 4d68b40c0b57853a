// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose faces share their corners: closed, open, folded back on
// themselves, through each other, of cubes that meet along edges.

#ifndef TRUELUX_TESTS_SUPPORT_MESH_SCENES_H_
#define TRUELUX_TESTS_SUPPORT_MESH_SCENES_H_

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/portable_random.h"
#include "support/scenes.h"

namespace truelux::testing {

/// A sphere of rings and segments around a point, its radius off by up to
/// `noise` of itself at every corner. 2 n (n - 1) triangles.
inline std::vector<Ring> SphereMesh(PortableRandom& random, int n,
                                    const Point3& centre, double radius,
                                    double noise) {
  std::vector<std::vector<Point3>> rings;
  for (int i = 0; i <= n; ++i) {
    rings.emplace_back();
    for (int j = 0; j < n; ++j) {
      const double polar = std::numbers::pi * i / n;
      const double turn = 2 * std::numbers::pi * j / n;
      const double r = radius * (1 + noise * random.Uniform(-1, 1));
      const double across = i == 0 || i == n ? 0 : std::sin(polar);
      rings.back().push_back({centre.x + r * across * std::cos(turn),
                              centre.y + r * across * std::sin(turn),
                              centre.z + r * std::cos(polar)});
    }
    if (i == 0 || i == n)  // a pole is one point
      rings.back().assign(static_cast<std::size_t>(n), rings.back().front());
  }
  std::vector<Ring> faces;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto at = [&](int ring, int segment) {
        return rings[static_cast<std::size_t>(ring)]
                    [static_cast<std::size_t>(segment % n)];
      };
      if (i < n - 1)
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      if (i > 0) faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return faces;
}

/// The faces between full and empty cells of a grid of n^3 cubes, each full
/// with probability 1 / one_in; fronts outwards. Cubes that meet in an edge or
/// a corner share it. inner: the faces between two full cells, too, twice.
inline std::vector<Ring> VoxelMesh(PortableRandom& random, int n, int one_in,
                                   const Point3& least, bool inner = false) {
  const auto cells = static_cast<std::size_t>(n);
  std::vector<bool> full(cells * cells * cells);
  for (std::size_t i = 0; i < full.size(); ++i)
    full[i] = random.OneIn(one_in);
  const auto is_full = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= n || y >= n || z >= n) return false;
    const auto column =
        static_cast<std::size_t>(x) * cells + static_cast<std::size_t>(y);
    return bool{full[column * cells + static_cast<std::size_t>(z)]};
  };
  std::vector<Ring> faces;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        if (!is_full(x, y, z)) continue;
        const auto at = [&](int dx, int dy, int dz) -> Point3 {
          return {least.x + x + dx, least.y + y + dy, least.z + z + dz};
        };
        const auto add = [&](bool hidden, const Ring& ring) {
          if (!hidden || inner) faces.push_back(ring);
        };
        add(is_full(x - 1, y, z),
            {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)});
        add(is_full(x + 1, y, z),
            {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
        add(is_full(x, y - 1, z),
            {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
        add(is_full(x, y + 1, z),
            {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)});
        add(is_full(x, y, z - 1),
            {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
        add(is_full(x, y, z + 1),
            {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
      }
    }
  }
  return faces;
}

/// Some faces left out, turned over, or there twice.
inline std::vector<Ring> Damaged(PortableRandom& random,
                                 const std::vector<Ring>& faces, int one_in) {
  std::vector<Ring> damaged;
  for (const Ring& ring : faces) {
    const int what = random.OneIn(one_in) ? random.Integer(0, 2) : 3;
    if (what == 0) continue;
    damaged.push_back(what == 1 ? Reversed(ring) : ring);
    if (what == 2) {
      damaged.push_back(random.OneIn(2) ? ring : Reversed(ring));
    }
  }
  return damaged;
}

/// Every corner moved.
inline std::vector<Ring> Moved(std::vector<Ring> faces, const Vector3& by) {
  for (Ring& ring : faces) {
    for (Point3& p : ring)
      p = {p.x + by.x, p.y + by.y, p.z + by.z};
  }
  return faces;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_MESH_SCENES_H_
