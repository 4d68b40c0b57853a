// SPDX-License-Identifier: GPL-3.0-or-later
// How large a kink is.

#ifndef TRUELUX_SURFACE_STRIP_SIZE_H_
#define TRUELUX_SURFACE_STRIP_SIZE_H_

#include <span>

#include <gmpxx.h>

#include "truelux/geometry.h"

#include "surface/plane_cut.h"
#include "surface/strip_arcs.h"

namespace truelux {

/// b [W/m^3] per channel of the kink that the arcs at (t, 0) make: beside other
/// kinks, E'(r; d) = gradient.d + b |m.d| with the plane's unit normal m
/// [docs/derivatives.md, (7)]. The relative error is below 1e-12. 0 without
/// arcs in a channel, or if 2^-160 of the arcs' own sizes are left.
///
///     b = -(1/2pi) integral over w in P, n.w > 0, of
///             (n.w) (sum over lines of jump g.w) dw
///
/// with unit vectors n and w, and 1 / g.w the distance to the line along w.
[[nodiscard]] Rgb KinkSizeOf(const PlaneCut& cut,
                             std::span<const StripArc> arcs,
                             const mpq_class& t);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_STRIP_SIZE_H_
