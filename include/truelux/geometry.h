// Points, vectors and colours as plain doubles; the kind is in the type.

#ifndef TRUELUX_GEOMETRY_H_
#define TRUELUX_GEOMETRY_H_

#include <array>

namespace truelux {

/// A position in the scene's frame [scene length unit]. Exact: a coordinate
/// is the binary64 number itself.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Point3&, const Point3&) = default;
};

/// A displacement or a normal; only its direction matters for a normal.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Vector3&, const Vector3&) = default;
};

/// One number per colour channel: red, green, blue.
using Rgb = std::array<double, 3>;

}  // namespace truelux

#endif  // TRUELUX_GEOMETRY_H_
