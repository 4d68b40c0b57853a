// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/critical_goal.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace truelux {

double CriticalGoal::UsefulChange(const KnownTriangle& /*known*/) const {
  // Summits want the best bound that there is.
  return HUGE_VAL;
}

bool CriticalGoal::IsSettled(const PlanMesh& mesh, int triangle,
                             const KnownTriangle& known) const {
  const double change = ChangeIn(known);
  if (!(LengthOf(known.centre.gradient) > change)) return false;
  const PlanTriangle& t = mesh.At(triangle);
  const std::array<PlanPoint, 3> corners = mesh.CornersOf(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    if (t.kinds[k] == SideKind::kInner) continue;
    const PlanPoint way = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    if (!(std::fabs(Dot(known.centre.gradient, way)) > change * LengthOf(way)))
      return false;
  }
  return true;
}

}  // namespace truelux
