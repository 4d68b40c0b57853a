// SPDX-License-Identifier: GPL-3.0-or-later
// More light than lamps would give without blockers there is nowhere.

#ifndef TRUELUX_ISOLUX_LIGHT_CEILING_H_
#define TRUELUX_ISOLUX_LIGHT_CEILING_H_

#include <span>

#include "isolux/light_features.h"
#include "isolux/plan_frame.h"
#include "isolux/sight.h"

namespace truelux {

/// The irradiance [W/m^2] at one point of the surface from the lamps of a sight,
/// as if nothing were before them, by Lambert's formula in double.
double UnblockedLight(const LightFeatures& features, const Sight& sight,
                      const PlanPoint& p);

/// A bound from above on E over the convex hull of some points of the surface:
/// the unblocked light at their middle, and how much it can change from there:
/// |grad (z l / rho^4)| <= z/rho^4 (a + 4 l h / rho^2), as in gradient_change.h.
/// +inf where a lamp touches them.
double LightCeiling(const LightFeatures& features, const Sight& sight,
                    std::span<const PlanPoint> points);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LIGHT_CEILING_H_
