// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors in binary64, for what is explained and drawn. Nothing is decided or
// certified with them.

#ifndef TRUELUX_BASE_VECTOR_MATH_H_
#define TRUELUX_BASE_VECTOR_MATH_H_

#include <algorithm>
#include <cmath>

#include "truelux/geometry.h"

namespace truelux {

[[nodiscard]] inline double Dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline Vector3 Sum(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// a - b.
[[nodiscard]] inline Vector3 Difference(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] inline Vector3 Times(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// From point a to point b.
[[nodiscard]] inline Vector3 FromTo(const Point3& a, const Point3& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

/// |a|, also where its square leaves binary64.
[[nodiscard]] inline double LengthOf(const Vector3& a) {
  return std::hypot(a.x, a.y, a.z);
}

/// a / |a|, for vectors of any length; 0 for 0.
[[nodiscard]] inline Vector3 UnitOf(const Vector3& a) {
  const double largest =
      std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (largest == 0) return a;
  const Vector3 scaled{a.x / largest, a.y / largest, a.z / largest};
  return Times(1 / LengthOf(scaled), scaled);
}

/// The angle between two directions [rad].
[[nodiscard]] inline double AngleBetween(const Vector3& a, const Vector3& b) {
  return std::atan2(LengthOf(Cross(a, b)), Dot(a, b));
}

}  // namespace truelux

#endif  // TRUELUX_BASE_VECTOR_MATH_H_
