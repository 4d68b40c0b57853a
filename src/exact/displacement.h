// SPDX-License-Identifier: GPL-3.0-or-later
// An infinitesimal step, as an exact number.
//
// One-sided limits of derivatives are taken next to a receiver: at r + step,
// with a step so small that no predicate whose sign is not zero at r has another
// sign there. Only zeros are decided anew, exactly.

#ifndef TRUELUX_EXACT_DISPLACEMENT_H_
#define TRUELUX_EXACT_DISPLACEMENT_H_

#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// Where a view is taken instead of at r, and of one vertex where it is instead
/// of at its place.
struct Displacement {
  Vec3<Exact> receiver{Exact(0), Exact(0), Exact(0)};
  VertexId vertex;  ///< none: no vertex is displaced
  Vec3<Exact> of_vertex{Exact(0), Exact(0), Exact(0)};
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_DISPLACEMENT_H_
