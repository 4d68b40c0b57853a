// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons whose form factor is known in closed form.

#ifndef TRUELUX_TESTS_RADIOMETRY_KNOWN_VIEWS_H_
#define TRUELUX_TESTS_RADIOMETRY_KNOWN_VIEWS_H_

#include <string>
#include <vector>

#include "radiometry/reference.h"
#include "support/scenes.h"

namespace truelux::testing {

/// A polygon, a receiver, and a closed form if there is one (else 0).
struct KnownView {
  std::string name;
  Ring ring;
  Point3 position;
  Vector3 normal{0, 0, 1};
  Real truth;
};

inline Real Arctangent(const Real& x) {
  return Atan2(x, Real(1));
}

/// The parallel rectangle a x b at height 1, one corner above the receiver
/// (Siegel and Howell, configuration factor of an element to a rectangle).
inline Real CornerRectangle(double a, double b) {
  const Real root_a = Sqrt(Real(1) + Real(a) * Real(a));
  const Real root_b = Sqrt(Real(1) + Real(b) * Real(b));
  return (Real(a) / root_a * Arctangent(Real(b) / root_a) +
          Real(b) / root_b * Arctangent(Real(a) / root_b)) /
         (Real(2) * Real::Pi());
}

/// The wall at distance 1, b wide and c high, one corner in the receiver plane
/// straight ahead.
inline Real CornerWall(double b, double c) {
  const Real root = Sqrt(Real(1) + Real(c) * Real(c));
  return (Arctangent(Real(b)) - Arctangent(Real(b) / root) / root) /
         (Real(2) * Real::Pi());
}

inline std::vector<KnownView> KnownViews() {
  const Real four(4);
  return {
      {"octant",
       {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
       {},
       {0, 0, 1},
       Real(1) / four},
      {"octant_to_minus_x",
       {{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}},
       {},
       {0, 0, 1},
       Real(1) / four},
      {"octant_from_minus_x",
       {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
       {},
       {0, 0, 1},
       Real(1) / four},
      {"octant_from_minus_y",
       {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
       {},
       {0, 0, 1},
       Real(1) / four},
      {"octant_across_x",
       {{1, 1, 0}, {1, -1, 0}, {0, 0, 2}},
       {},
       {0, 0, 7},
       Real(1) / four},
      {"octant_across_minus_x",
       {{-1, -1, 0}, {-1, 1, 0}, {0, 0, 2}},
       {},
       {0, 0, 1},
       Real(1) / four},
      {"rectangle_above_corner",
       Ceiling(0, 2, 0, 3, 1),
       {},
       {0, 0, 1},
       CornerRectangle(2, 3)},
      {"square_above",
       Ceiling(-1, 1, -1, 1, 1),
       {},
       {0, 0, 1},
       four * CornerRectangle(1, 1)},
      {"wall_on_receiver_plane",
       {{1, 0, 0}, {1, 2, 0}, {1, 2, 3}, {1, 0, 3}},
       {},
       {0, 0, 1},
       CornerWall(2, 3)},
      {"wall_through_receiver_plane",
       {{1, -2, -5}, {1, 2, -5}, {1, 2, 3}, {1, -2, 3}},
       {},
       {0, 0, 1},
       Real(2) * CornerWall(2, 3)},
      {"wall_behind_through_receiver_plane",
       {{-1, 2, -5}, {-1, -2, -5}, {-1, -2, 3}, {-1, 2, 3}},
       {},
       {0, 0, 1},
       Real(2) * CornerWall(2, 3)},
      {"from_below_minus_z",
       Floor(0, 2, 0, 3, -1),
       {},
       {0, 0, -1},
       CornerRectangle(2, 3)},
      {"along_x",
       {{1, 0, 0}, {1, 2, 0}, {1, 2, 3}, {1, 0, 3}},
       {},
       {5, 0, 0},
       CornerRectangle(2, 3)},
      {"along_minus_y",
       {{0, -1, 0}, {2, -1, 0}, {2, -1, 3}, {0, -1, 3}},
       {},
       {0, -0.1, 0},
       CornerRectangle(2, 3)},
      {"far_from_origin",
       Ceiling(1000, 1002, -2000, -1997, 501),
       {1000, -2000, 500},
       {0, 0, 1},
       CornerRectangle(2, 3)},
      {"tilted", Ceiling(0, 2, 0, 3, 1), {0.1, 0.2, 0.3}, {0.3, -0.1, 0.7}, 0},
      {"tilted_through_horizon",
       Ceiling(-2, 5, -4, 3, 1),
       {0.1, 0.2, 0.3},
       {2, -1, 0.5},
       0},
      {"tilted_in_two_axes",
       {{1, 0, 0.5}, {1, 2, 0}, {1, 2, 3}, {1, 0, 3}},
       {},
       {3, 0, 4},
       0},
  };
}

inline Real TruthOf(const KnownView& view) {
  if (Real(0) < view.truth) return view.truth;
  return FormFactor(view.ring, view.position, view.normal);
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_KNOWN_VIEWS_H_
