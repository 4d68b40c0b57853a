// SPDX-License-Identifier: GPL-3.0-or-later
// The form factor of a sphere that the horizon may cut (docs/method.md
// section 10).

#ifndef TRUELUX_RADIOMETRY_SPHERE_SOURCE_H_
#define TRUELUX_RADIOMETRY_SPHERE_SOURCE_H_

namespace truelux {

/// How a receiver sees a sphere of radius R whose center is at distance d >= R
/// in the unit direction w, n the receiver's unit normal. Each number is given
/// by itself, so that it can be right in all its bits where the others cancel.
struct SphereView {
  double s = 0;           ///< R / d, the sine of the angular radius, in (0, 1]
  double c = 0;           ///< n . w, in [-1, 1]
  double k = 0;           ///< sqrt(1 - s^2), the cosine of the angular radius
  double s_plus_c = 0;    ///< <= 0: the sphere has set
  double s_minus_c = 0;   ///< <= 0: all of it is above the horizon
  double one_plus_c = 0;  ///< 1 + c
};

/// E / M of the part above the horizon, in [0, 1].
///
/// Relative error <= 4e-15 measured over s from 1e-12 to 1 - 1e-14 and c from
/// -s (1 - 1e-12) to s, if each number of the view is off by at most one unit
/// in the last place.
[[nodiscard]] double SphereFormFactor(const SphereView& view);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_SPHERE_SOURCE_H_
