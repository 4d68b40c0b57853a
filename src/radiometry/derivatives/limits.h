// SPDX-License-Identifier: GPL-3.0-or-later
// Kinks: derivatives on both sides of the planes where they may jump.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_LIMITS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_LIMITS_H_

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "exact/arb_real.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/kink_planes.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// Per channel.
using ArbRgb = std::array<ArbReal, 3>;

/// A plane across which the Jacobian jumps: on both sides it is J + c m^T and
/// J - c m^T, m the unit normal, on the side of m the former.
struct JacobianJump {
  const KinkPlane* plane = nullptr;
  Vec3<ArbReal> normal;                 ///< m
  std::array<Vec3<ArbReal>, 3> height;  ///< c [W/m^3] per channel
};

/// The Jacobians around a receiver.
struct JacobianLimits {
  /// Mean of the limits from all sides: row p of channel k is mean[k][p].
  std::array<std::array<Vec3<ArbReal>, 3>, 3> mean;
  std::vector<JacobianJump> jumps;
  /// A bound on the size of the numbers above; what is below 2^-490 of it is 0.
  ArbRgb size;

  /// Whether a number of a channel is zero.
  [[nodiscard]] bool IsZero(const ArbReal& x, std::size_t channel) const {
    return x.IsAtMost(size[channel].TimesTwoTo(-490));
  }
};

/// Coordinates are multiples of 2^low and less than 2^high.
struct CoordinateRange {
  int low = 0;
  int high = 0;

  /// An exponent e such that a step of 2^e changes no sign of a predicate.
  [[nodiscard]] long StepExponent() const;

  /// M / length of the scene [W/m^3]: what derivatives are compared with that
  /// may all vanish with the step.
  [[nodiscard]] ArbReal Slope(double exitance) const {
    return ArbReal(64, Exact(exitance)).TimesTwoTo(-high);
  }
};

/// Of the scene and the receiver of a query.
CoordinateRange CoordinateRangeOf(const ContourQuery& query);

/// The precision [bits] at which sums beside such a step are taken: the line of
/// an edge that goes through r is then 2^e away, and parts of 2^-e cancel.
inline slong StepPrecision(long exponent) {
  return 768 - exponent;
}

/// Takes the Jacobians at r + step for several steps that are smaller than what
/// any predicate that is not zero at r can feel. The limits are off by less
/// than 2^-500 of `size`, and enclosed together with that.
///
/// query: of the receiver; whole_sphere as it says. planes: FindKinkPlanes.
JacobianLimits FindLimits(const ContourEngine& engine,
                          const ContourQuery& query,
                          std::span<const KinkPlane> planes);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_LIMITS_H_
