// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance with 421 digits, by the vector form of Lambert's formula and by
// nothing that the library uses.

#ifndef TRUELUX_TESTS_RADIOMETRY_REFERENCE_H_
#define TRUELUX_TESTS_RADIOMETRY_REFERENCE_H_

#include <array>
#include <cstddef>
#include <vector>

#include "truelux/geometry.h"

#include "support/real.h"

namespace truelux::testing {

using RealVector = std::array<Real, 3>;

inline Real Dot(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RealVector Cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

inline RealVector Combine(const Real& s, const RealVector& a, const Real& t,
                          const RealVector& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

inline RealVector ToRealVector(const Vector3& v) {
  return {v.x, v.y, v.z};
}

/// p - r.
inline RealVector Relative(const Point3& p, const Point3& r) {
  return {Real(p.x) - Real(r.x), Real(p.y) - Real(r.y), Real(p.z) - Real(r.z)};
}

/// The part of a ring of directions with plane . d >= 0 (Sutherland and
/// Hodgman); an empty ring if there is none.
inline std::vector<RealVector> Clip(const std::vector<RealVector>& ring,
                                    const RealVector& plane) {
  std::vector<RealVector> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RealVector& a = ring[i];
    const RealVector& b = ring[(i + 1) % ring.size()];
    const Real f_a = Dot(plane, a);
    const Real f_b = Dot(plane, b);
    if (Real(0) <= f_a) result.push_back(a);
    if ((f_a < Real(0) && Real(0) < f_b) || (f_b < Real(0) && Real(0) < f_a)) {
      const Real sign(Real(0) < f_a ? 1 : -1);
      result.push_back(Combine(sign * f_a, b, -(sign * f_b), a));
    }
  }
  return result;
}

/// (1/2 pi) |sum of beta N.n / (|N| |n|)| over the ring's sides: the form
/// factor of the region inside, which must be above the horizon.
inline Real FormFactorOfRing(const std::vector<RealVector>& ring,
                             const RealVector& normal) {
  Real sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RealVector& a = ring[i];
    const RealVector& b = ring[(i + 1) % ring.size()];
    const RealVector across = Cross(a, b);
    const Real length = Sqrt(Dot(across, across));
    if (length <= Real(0)) continue;
    sum = sum + Atan2(length, Dot(a, b)) * Dot(across, normal) / length;
  }
  return Abs(sum) / (Real(2) * Real::Pi() * Sqrt(Dot(normal, normal)));
}

/// The form factor of a polygon that nothing hides.
inline Real FormFactor(const std::vector<Point3>& ring, const Point3& position,
                       const Vector3& normal) {
  std::vector<RealVector> directions;
  for (const Point3& p : ring)
    directions.push_back(Relative(p, position));
  const RealVector n = ToRealVector(normal);
  return FormFactorOfRing(Clip(directions, n), n);
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_REFERENCE_H_
