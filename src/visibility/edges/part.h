// SPDX-License-Identifier: GPL-3.0-or-later
// A cone whose edges are candidates for arcs.

#ifndef TRUELUX_VISIBILITY_EDGES_PART_H_
#define TRUELUX_VISIBILITY_EDGES_PART_H_

#include <array>

#include "visibility/edges/cone.h"

namespace truelux {

/// What is seen of a piece of the source, or of a piece that hides some of it:
/// a cone with, per edge, the id of the candidate edge it is; kNoCandidate for
/// an edge that is left out.
struct Part {
  static constexpr int kNoCandidate = -1;

  Cone cone;
  std::array<int, Cone::kMaxEdges> candidates{};
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_PART_H_
