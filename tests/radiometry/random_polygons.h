// SPDX-License-Identifier: GPL-3.0-or-later
// Random polygons of every size and place, for tests.

#ifndef TRUELUX_TESTS_RADIOMETRY_RANDOM_POLYGONS_H_
#define TRUELUX_TESTS_RADIOMETRY_RANDOM_POLYGONS_H_

#include <cmath>
#include <vector>

#include "truelux/geometry.h"

#include "support/portable_random.h"

namespace truelux::testing {

/// A receiver and a convex polygon around some direction above its horizon.
struct RandomView {
  Point3 position;
  Vector3 normal;
  std::vector<Point3> ring;
};

/// size: angular [rad], up to 1. elevation: of the middle above the receiver
/// plane [rad]; smaller than size: the polygon straddles it. offset: the
/// scene's distance from the origin.
inline RandomView MakeRandomView(PortableRandom& random, double size,
                                 double elevation, double offset) {
  const double azimuth = random.Uniform(-3, 3);
  const double c = std::cos(elevation);
  const double s = std::sin(elevation);
  const double ca = std::cos(azimuth);
  const double sa = std::sin(azimuth);
  const double scale = random.Uniform(0.5, 2);
  RandomView view;
  view.position = {offset * random.Uniform(-1, 1),
                   offset * random.Uniform(-1, 1),
                   offset * random.Uniform(-1, 1)};
  view.normal = {0, 0, std::ldexp(1.0, random.Integer(-3, 3))};
  const int count = random.Integer(3, 5);
  const double start = random.Uniform(0, 6);
  for (int i = 0; i < count; ++i) {
    const double angle =
        start - (i + random.Uniform(-0.2, 0.2)) * 6.283185307179586 / count;
    const double u = 0.6 * size * std::cos(angle);
    const double v = 0.6 * size * std::sin(angle);
    view.ring.push_back(
        {view.position.x + scale * (c * ca - u * sa - v * ca * s),
         view.position.y + scale * (c * sa + u * ca - v * sa * s),
         view.position.z + scale * (s + v * c)});
  }
  return view;
}

/// The same view in a tilted frame: full mantissas everywhere. Rounded; the
/// polygon changes by some units in the last place.
inline RandomView Tilted(const RandomView& view) {
  // A rotation by 3-4-5 and 5-12-13 triangles.
  const auto turn = [](double& x, double& y, double& z) {
    const double x1 = 0.6 * x - 0.8 * z;
    const double z1 = 0.8 * x + 0.6 * z;
    const double y1 = (5 * y - 12 * z1) / 13;
    x = x1;
    z = (12 * y + 5 * z1) / 13;
    y = y1;
  };
  RandomView result = view;
  turn(result.position.x, result.position.y, result.position.z);
  turn(result.normal.x, result.normal.y, result.normal.z);
  for (Point3& p : result.ring)
    turn(p.x, p.y, p.z);
  return result;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_RANDOM_POLYGONS_H_
