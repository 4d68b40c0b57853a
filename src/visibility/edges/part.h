// SPDX-License-Identifier: GPL-3.0-or-later
// A cone whose edges are candidates for arcs.

#ifndef TRUELUX_VISIBILITY_EDGES_PART_H_
#define TRUELUX_VISIBILITY_EDGES_PART_H_

#include <array>

#include "base/ids.h"
#include "visibility/edges/cone.h"

namespace truelux {

/// Index of an edge that arcs may lie on, among those of one source; the first
/// of several in one plane owns the arcs there.
using CandidateId = Id<struct CandidateTag>;

/// What is seen of a piece of the source, or of a piece that hides some of it:
/// a cone with, per edge, the candidate edge it is; none for an edge that is
/// left out.
struct Part {
  Cone cone;
  std::array<CandidateId, Cone::kMaxEdges> candidates;
  bool has_candidates = false;  ///< inside a mesh most parts have none
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_PART_H_
