// SPDX-License-Identifier: GPL-3.0-or-later
// Random soups of polygons: on a small integer lattice, where everything
// coincides, or in general position.

#ifndef TRUELUX_TESTS_SUPPORT_RANDOM_SCENE_H_
#define TRUELUX_TESTS_SUPPORT_RANDOM_SCENE_H_

#include <algorithm>
#include <vector>

#include "truelux/receiver.h"

#include "support/portable_random.h"
#include "support/scenes.h"

namespace truelux::testing {

inline double RandomCoordinate(PortableRandom& random, bool lattice,
                               int range) {
  return lattice ? random.Integer(-range, range)
                 : random.Uniform(-range, range);
}

inline Point3 RandomPoint(PortableRandom& random, bool lattice, int range) {
  return {RandomCoordinate(random, lattice, range),
          RandomCoordinate(random, lattice, range),
          RandomCoordinate(random, lattice, range)};
}

inline bool OnOneLine(const Point3& a, const Point3& b, const Point3& c) {
  const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vector3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z &&
         u.x * v.y == u.y * v.x;
}

/// `count` triangles and (lattice only, where they are exactly planar)
/// parallelograms; about half of them emit.
inline std::vector<TestFace> RandomScene(PortableRandom& random, bool lattice,
                                         int count, int range = 4) {
  std::vector<TestFace> faces;
  while (static_cast<int>(faces.size()) < count) {
    const Point3 a = RandomPoint(random, lattice, range);
    const Point3 b = RandomPoint(random, lattice, range);
    const Point3 c = RandomPoint(random, lattice, range);
    if (OnOneLine(a, b, c)) continue;
    Ring ring = {a, b, c};
    if (lattice && random.OneIn(2)) {
      ring.push_back({a.x + c.x - b.x, a.y + c.y - b.y, a.z + c.z - b.z});
    }
    const double m = random.OneIn(2) ? random.Integer(1, 5) : 0;
    faces.push_back({ring, {m, m * 0.5, m * m}});
  }
  return faces;
}

inline Receiver RandomReceiver(PortableRandom& random, bool lattice,
                               int range = 4) {
  Receiver r;
  r.position = RandomPoint(random, lattice, range);
  if (lattice && random.OneIn(2)) r.position.x += 0.5;
  do {
    const Point3 n = RandomPoint(random, lattice, 3);
    r.normal = {n.x, n.y, n.z};
  } while (r.normal.x == 0 && r.normal.y == 0 && r.normal.z == 0);
  return r;
}

/// (p - a) . N of the plane of a ring; its sign is exact on a lattice, and in
/// general position nothing is close to zero.
inline double AbovePlane(const Ring& ring, const Point3& p) {
  const Point3& a = ring[0];
  const Vector3 u{ring[1].x - a.x, ring[1].y - a.y, ring[1].z - a.z};
  const Vector3 v{ring[2].x - a.x, ring[2].y - a.y, ring[2].z - a.z};
  return (u.y * v.z - u.z * v.y) * (p.x - a.x) +
         (u.z * v.x - u.x * v.z) * (p.y - a.y) +
         (u.x * v.y - u.y * v.x) * (p.z - a.z);
}

/// The faces without those that lie in the plane of an earlier one.
inline std::vector<TestFace> WithoutCoplanarFaces(
    const std::vector<TestFace>& faces) {
  std::vector<TestFace> kept;
  for (const TestFace& face : faces) {
    const bool coplanar = std::ranges::any_of(kept, [&](const TestFace& k) {
      return std::ranges::all_of(face.ring, [&k](const Point3& p) {
        return AbovePlane(k.ring, p) == 0;
      });
    });
    if (!coplanar) kept.push_back(face);
  }
  return kept;
}

/// The six faces of the cube |x|, |y|, |z| <= half, fronts inwards.
inline std::vector<Ring> BoxAround(double h) {
  return {{{-h, -h, h}, {-h, h, h}, {h, h, h}, {h, -h, h}},
          {{-h, -h, -h}, {h, -h, -h}, {h, h, -h}, {-h, h, -h}},
          {{h, -h, -h}, {h, -h, h}, {h, h, h}, {h, h, -h}},
          {{-h, -h, -h}, {-h, h, -h}, {-h, h, h}, {-h, -h, h}},
          {{-h, h, -h}, {h, h, -h}, {h, h, h}, {-h, h, h}},
          {{-h, -h, -h}, {-h, -h, h}, {h, -h, h}, {h, -h, -h}}};
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_RANDOM_SCENE_H_
