// SPDX-License-Identifier: GPL-3.0-or-later
// The floors on which contours are measured.

#ifndef TRUELUX_BENCH_ISOLUX_FLOORS_H_
#define TRUELUX_BENCH_ISOLUX_FLOORS_H_

#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

namespace truelux::bench {

/// A floor to be measured: the surface "floor" of a scene, and face 1 of it.
struct IsoluxFloor {
  std::string name;
  Scene scene;
  /// Of a rectangle, near the floor's extent, that grids are laid over.
  Point3 corner;
  double width = 0;   ///< of the rectangle, along Isolux::right [length]
  double height = 0;  ///< along Isolux::up [length]
};

/// The Cornell box, a room of a hundred faces, and two of the pictures of
/// Figure 7. Throws std::invalid_argument if an example cannot be read.
std::vector<IsoluxFloor> IsoluxFloors();

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_ISOLUX_FLOORS_H_
