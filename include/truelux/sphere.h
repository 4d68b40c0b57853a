// SPDX-License-Identifier: GPL-3.0-or-later
// A uniformly emitting sphere as a source, unoccluded.

#ifndef TRUELUX_SPHERE_H_
#define TRUELUX_SPHERE_H_

#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/receiver.h"

namespace truelux {

/// A sphere that emits uniformly from its outside.
struct Sphere {
  Point3 center;      ///< in the scene's frame
  double radius = 0;  ///< > 0, in the unit of the coordinates
  Rgb exitance{};     ///< M [W/m^2]
};

/// The irradiance [W/m^2] at a receiver outside a sphere. Nothing blocks, and
/// what the receiver's horizon cuts off counts as dark.
///
/// Heitz, Geometric Derivation of the Irradiance of Polygonal Lights (2017),
/// equation (16): M (R / d)^2 cos for a sphere above the horizon, R its radius
/// and d its distance; docs/method.md section 10 for one that the horizon cuts.
/// In double, without a proven bound:
/// relative error <= 4e-15 measured against 120 digits, from the input numbers
/// to the result, over R / d from 1e-12 to 1 (the receiver touches the sphere)
/// and from a sphere that has all but set (the part above the horizon is
/// 1e-12 R high) to one at the zenith, 1e9 R from the origin. Form factors
/// below 2^-1022 lose digits. Multiplying all coordinates, the radius included,
/// or the normal by a power of two leaves the bits as they are.
///
/// Throws std::invalid_argument if a number is not finite, the radius is not
/// positive, the normal is zero or the receiver is inside the sphere (decided
/// exactly). Receiver::on_face is not looked at.
[[nodiscard]] TRUELUX_EXPORT Rgb IrradianceFromSphere(const Receiver& receiver,
                                                      const Sphere& sphere);

}  // namespace truelux

#endif  // TRUELUX_SPHERE_H_
