// SPDX-License-Identifier: GPL-3.0-or-later
// The Newell normal of a ring and what it tells, at any number type.

#ifndef TRUELUX_SCENE_NEWELL_H_
#define TRUELUX_SCENE_NEWELL_H_

#include <array>
#include <cstddef>
#include <span>

#include "truelux/geometry.h"

#include "exact/vec3.h"

namespace truelux {

/// to - from.
template <class NT>
Vec3<NT> Displacement(const Point3& from, const Point3& to) {
  return {NT(to.x) - NT(from.x), NT(to.y) - NT(from.y), NT(to.z) - NT(from.z)};
}

/// The doubled vector area of a ring. ring: n x 3, n >= 3.
template <class NT>
Vec3<NT> NewellNormal(std::span<const Point3> ring) {
  Vec3<NT> previous = Displacement<NT>(ring[0], ring[1]);
  Vec3<NT> current = Displacement<NT>(ring[0], ring[2]);
  Vec3<NT> normal = Cross(previous, current);
  for (std::size_t i = 3; i < ring.size(); ++i) {
    previous = current;
    current = Displacement<NT>(ring[0], ring[i]);
    normal = normal - Cross(current, previous);
  }
  return normal;
}

/// Height of a point over the plane with that normal through an origin.
template <class NT>
NT HeightOver(const Vec3<NT>& normal, const Point3& origin,
              const Point3& point) {
  return Dot(normal, Displacement<NT>(origin, point));
}

/// Component 0, 1 or 2.
template <class NT>
const NT& Component(const Vec3<NT>& v, int axis) {
  const std::array<const NT*, 3> components{&v.x, &v.y, &v.z};
  return *components[static_cast<std::size_t>(axis)];
}

inline double Coordinate(const Point3& p, int axis) {
  const std::array<double, 3> coordinates{p.x, p.y, p.z};
  return coordinates[static_cast<std::size_t>(axis)];
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_NEWELL_H_
