// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in which several edges or vertices lie on one ray from the receiver,
// exactly or nearly.

#ifndef TRUELUX_BENCH_CONJUNCTIVE_SCENES_H_
#define TRUELUX_BENCH_CONJUNCTIVE_SCENES_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "support/portable_random.h"

namespace truelux::bench {

/// One receiver and what it sees. Unless something else is said, the source is
/// the square |x|, |y| <= 1/2 at z = 1; it emits M = 1 downwards. The blockers
/// do not pass through each other.
struct ConjunctiveCase {
  Scene scene;
  Receiver receiver;
  double side = 1;  ///< of the source
};

struct ConjunctiveFamily {
  std::string name;
  std::function<ConjunctiveCase(testing::PortableRandom&)> make;
};

/// All families, by name:
///
/// - triangles: at random, for comparison; `side` is that of the source if it
///   is not 1;
/// - edges through a point: one edge of each of k triangles, exactly through
///   one ray that meets the source;
/// - vertex on / before ...: a corner of a triangle, exactly;
/// - edges in a plane: of two triangles, or of one and of the source, in
///   exactly one plane with the receiver;
/// - grids: squares in two layers, whose edges coincide for receivers at
///   certain points of their lattice; boxes: the same of closed boxes;
/// - missing by d: as the first ones, but one edge is moved by d in the image
///   plane, at unit distance.
///
/// Where "exactly" is said, coordinates have few bits. Every other receiver
/// (at random) is tilted.
std::vector<ConjunctiveFamily> ConjunctiveFamilies();

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_CONJUNCTIVE_SCENES_H_
