// SPDX-License-Identifier: GPL-3.0-or-later
// Points, vectors and colours as plain doubles; the kind is in the type.

#ifndef TRUELUX_GEOMETRY_H_
#define TRUELUX_GEOMETRY_H_

#include <array>

namespace truelux {

/// A position in the scene's frame, which is right-handed. The unit of length
/// is the user's choice: irradiance does not depend on it. A coordinate is
/// exactly the binary64 number that it is; nothing is rounded to a grid.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Point3&, const Point3&) = default;
};

/// A displacement or a normal, in the same frame. Only the direction of a
/// normal matters, not its length.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Vector3&, const Vector3&) = default;
};

/// One number per colour channel: red, green, blue. The channels never mix;
/// they may as well be any three wavelengths.
using Rgb = std::array<double, 3>;

}  // namespace truelux

#endif  // TRUELUX_GEOMETRY_H_
