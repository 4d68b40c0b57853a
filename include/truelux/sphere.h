// A uniformly emitting sphere as a source, unoccluded.

#ifndef TRUELUX_SPHERE_H_
#define TRUELUX_SPHERE_H_

#include "truelux/geometry.h"
#include "truelux/receiver.h"

namespace truelux {

/// A sphere that emits `exitance` [W/m^2] from its outside.
struct Sphere {
  Point3 center;
  double radius = 0;  ///< > 0, in the unit of the coordinates
  Rgb exitance{};
};

/// The irradiance [W/m^2] at a receiver outside the sphere; nothing else is
/// there, and what the receiver's horizon cuts off counts as dark.
///
/// In double, without a proven bound: relative error <= 2e-14 measured, also
/// where the sphere has almost set, given the direction and distance of the
/// center from the receiver in double (Heitz 2017 (16) above the horizon;
/// docs/method.md section 10 where the horizon cuts it). Throws std::invalid_argument if the radius is not positive, a
/// number is not finite, the normal is zero or the receiver is inside.
[[nodiscard]] Rgb IrradianceFromSphere(const Receiver& receiver,
                                       const Sphere& sphere);

}  // namespace truelux

#endif  // TRUELUX_SPHERE_H_
