// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving out of a cut what makes no difference to kinks.

#ifndef TRUELUX_SURFACE_CUT_SIEVE_H_
#define TRUELUX_SURFACE_CUT_SIEVE_H_

#include "surface/plane_cut.h"

namespace truelux {

/// Leaves out the parts of facets that cannot lie in the direction of a light
/// and of two lines at which strips may differ, seen from the trace from x = 0
/// to 1: kinks are the same without them. If there is no kink all is left out.
/// Decided exactly. Requires marked parts, and a cut without crossings.
void DropWithoutEffect(PlaneCut& cut);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_CUT_SIEVE_H_
