// SPDX-License-Identifier: GPL-3.0-or-later
// Where irradiance has no extremum and no saddle.

#ifndef TRUELUX_ISOLUX_CRITICAL_GOAL_H_
#define TRUELUX_ISOLUX_CRITICAL_GOAL_H_

#include "isolux/mesh_search.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A triangle is settled if the gradient is nowhere 0 in it, and if along those
/// of its sides on which it may jump, or which are the end of the surface, E is
/// monotonic. Then critical points are at corners at most.
class CriticalGoal : public SearchGoal {
 public:
  [[nodiscard]] double UsefulChange(const KnownTriangle& known) const override;
  [[nodiscard]] bool IsSettled(const PlanMesh& mesh, int triangle,
                               const KnownTriangle& known) const override;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_CRITICAL_GOAL_H_
