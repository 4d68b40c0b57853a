// SPDX-License-Identifier: GPL-3.0-or-later
// Angles as a receiver sees them, with 120 digits.

#ifndef TRUELUX_TESTS_BASELINES_SEEN_FROM_H_
#define TRUELUX_TESTS_BASELINES_SEEN_FROM_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

#include "exact/vec3.h"
#include "support/real.h"

namespace truelux::testing {

using RealVec = Vec3<ShortReal>;

/// p - r.
inline RealVec SeenFrom(const Receiver& r, const Point3& p) {
  const RealVec from{r.position.x, r.position.y, r.position.z};
  return RealVec{p.x, p.y, p.z} - from;
}

inline std::vector<RealVec> SeenFrom(const Receiver& r,
                                     const std::vector<Point3>& loop) {
  std::vector<RealVec> seen;
  seen.reserve(loop.size());
  for (const Point3& p : loop)
    seen.push_back(SeenFrom(r, p));
  return seen;
}

inline ShortReal LengthOf(const RealVec& v) {
  return Sqrt(Dot(v, v));
}

/// [rad], in [0, pi].
inline double AngleBetween(const RealVec& a, const RealVec& b) {
  return Atan2(LengthOf(Cross(a, b)), Dot(a, b)).ToDouble();
}

/// Of a direction to the plane through r with normal N [rad], signed.
inline double AngleToPlane(const RealVec& d, const RealVec& plane) {
  return Atan2(Dot(d, plane), LengthOf(Cross(d, plane))).ToDouble();
}

/// The largest angle between two points [rad].
inline double Diameter(const std::vector<RealVec>& loop) {
  double largest = 0;
  for (const RealVec& a : loop) {
    for (const RealVec& b : loop)
      largest = std::max(largest, AngleBetween(a, b));
  }
  return largest;
}

/// E / M of a loop: positive if it runs counter-clockwise seen from r.
inline ShortReal SignedFormFactor(const std::vector<RealVec>& loop,
                                  const Vector3& normal) {
  const RealVec n{normal.x, normal.y, normal.z};
  ShortReal sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const RealVec& a = loop[i];
    const RealVec& b = loop[(i + 1) % loop.size()];
    const RealVec across = Cross(a, b);
    const ShortReal length = LengthOf(across);
    sum = sum - Atan2(length, Dot(a, b)) * Dot(across, n) / length;
  }
  return sum / (ShortReal(2) * ShortReal::Pi() * LengthOf(n));
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_BASELINES_SEEN_FROM_H_
