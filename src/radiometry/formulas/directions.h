// SPDX-License-Identifier: GPL-3.0-or-later
// "directions": the same sum with the directions of edges instead of slopes,
// so vertical edges need no special treatment. S (44), (45). Corrections: errata
// 19, 20 and 21.
//
// Bounded regions only, as with image-plane. Error: u / size^2, and
// u / elevation near the horizon.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_DIRECTIONS_H_
#define TRUELUX_RADIOMETRY_FORMULAS_DIRECTIONS_H_

#include "radiometry/formulas/image_vertex.h"

namespace truelux {

/// The form factor [1] of a region without vertices on the horizon.
template <class T>
T Directions(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    sum =
        PlusFiniteEdge(sum, ImageOf(region.From(arc)), ImageOf(region.To(arc)));
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_DIRECTIONS_H_
