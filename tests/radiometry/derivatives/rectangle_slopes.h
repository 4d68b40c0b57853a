// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the irradiance of rectangles in closed form: what a straight
// edge of a lamp parallel to the receiver plane adds per metre that it moves.
//
// The lamp of 1 W/m^2 hangs at height h over a receiver at the origin, whose
// normal is +z. A point (X, Y) of the lamp adds h^2 / (pi (X^2 + Y^2 + h^2)^2)
// to E per area.

#ifndef TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_RECTANGLE_SLOPES_H_
#define TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_RECTANGLE_SLOPES_H_

#include <cmath>
#include <numbers>

namespace truelux::testing {

/// That over the line X = x from Y = y0 to y1: dE/dx of an edge there with the
/// lamp on the side of less X [W/m^3].
inline double LineSlope(double h, double x, double y0, double y1) {
  const double a = h * h + x * x;
  const double root = std::sqrt(a);
  const auto primitive = [a, root](double y) {
    return y / (2 * a * (a + y * y)) + std::atan(y / root) / (2 * a * root);
  };
  return h * h / std::numbers::pi * (primitive(y1) - primitive(y0));
}

/// The same with the weight Y [W/m^2].
inline double LineMoment(double h, double x, double y0, double y1) {
  const double a = h * h + x * x;
  return h * h / std::numbers::pi * (0.5 / (a + y0 * y0) - 0.5 / (a + y1 * y1));
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_RECTANGLE_SLOPES_H_
