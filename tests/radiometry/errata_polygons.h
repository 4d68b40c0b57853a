// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons for the tests of corrected equations, and their true irradiance.

#ifndef TRUELUX_TESTS_RADIOMETRY_ERRATA_POLYGONS_H_
#define TRUELUX_TESTS_RADIOMETRY_ERRATA_POLYGONS_H_

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "exact/vec3.h"

namespace truelux::testing {

using std::numbers::pi;
using Vector = Vec3<double>;

/// A polygon seen from r = 0, counter-clockwise: clockwise in the image plane.
using Polygon = std::vector<Vector>;

/// The directions, as points of the plane p . d = 1.
inline Polygon OnPlane(const Polygon& directions, const Vector& p) {
  Polygon polygon;
  for (const Vector& d : directions)
    polygon.push_back((1 / Dot(p, d)) * d);
  return polygon;
}

inline Polygon Reversed(const Polygon& polygon) {
  return {polygon.rbegin(), polygon.rend()};
}

inline double Truth(const Polygon& polygon) {
  SceneBuilder builder;
  std::vector<Point3> ring;
  for (const Vector& v : polygon)
    ring.push_back({v.x, v.y, v.z});
  builder.AddFace(ring, {1, 1, 1});
  const auto scene = builder.Build();
  return Oracle(*scene.value).Evaluate({{0, 0, 0}, {0, 0, 1}, 0}).value[0];
}

inline const Polygon kPolygon = OnPlane(
    {{.5, -.3, 1}, {.2, .9, 1}, {1.5, 1.1, 1}, {1.4, -.7, 1}}, {.1, -.05, 1});
/// Its first edge is vertical in the image plane.
inline const Polygon kVertical = OnPlane(
    {{.5, -.3, 1}, {.5, .9, 1}, {1.5, 1.1, 1}, {1.4, -.7, 1}}, {.1, -.05, 1});
/// One vertex on the horizon.
inline const Polygon kOneAtInfinity =
    OnPlane({{.9, -.3, 0}, {.4, -.5, .6}, {.3, .4, .7}}, {.8, .1, .5});
/// An edge on the horizon, across the positive x axis.
inline const Polygon kAcross = OnPlane(
    {{.8, .5, 0}, {.4, .5, .7}, {.5, -.4, .6}, {1, -.5, 0}}, {.9, .05, .4});

inline const Vector& Next(const Polygon& p, std::size_t i) {
  return p[(i + 1) % p.size()];
}

/// Calls f(v, v') for every edge and adds up what it returns.
template <class Function>
double SumOfEdges(const Polygon& p, const Function& f) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += f(p[i], Next(p, i));
  return sum;
}

inline double Length(const Vector& v) {
  return std::sqrt(Dot(v, v));
}

/// beta cos gamma of an edge, with gamma to the inward normal.
inline double LambertTerm(const Vector& v, const Vector& w) {
  const Vector n = Cross(v, w);
  return -std::atan2(Length(n), Dot(v, w)) * n.z / Length(n);
}

/// C (ay - bx) atan[C (ax + by)].
inline double DirectionTerm(double x, double y, double a, double b) {
  const double k = a * y - b * x;
  const double s = std::sqrt(a * a + b * b + k * k);
  return k / s * std::atan((a * x + b * y) / s);
}

struct Image {
  explicit Image(const Vector& v)
      : x(v.z == 0 ? v.x : v.x / v.z),
        y(v.z == 0 ? v.y : v.y / v.z),
        infinite(v.z == 0) {}

  double x;
  double y;
  bool infinite;
};

inline constexpr double kClose = 1e-11;  // of numbers printed with 12 digits

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_ERRATA_POLYGONS_H_
