// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/level_goal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace truelux {

bool LevelGoal::HasOneOf(const ValueRange& range) const {
  const auto first = std::ranges::lower_bound(levels_, range.least);
  return first != levels_.end() && *first <= range.most;
}

double LevelGoal::UsefulChange(const KnownTriangle& known) const {
  // To cross a level in one arc, or to miss it; for the level that asks for
  // least.
  const double slope = LengthOf(known.centre.gradient);
  double useful = HUGE_VAL;
  for (const double level : levels_) {
    const double apart = std::fabs(known.centre.light.value - level);
    useful =
        std::min(useful, std::max(slope, 2 * (apart / known.radius - slope)));
  }
  return useful;
}

bool LevelGoal::IsFlat(const KnownTriangle& known) const {
  const LightSample& centre = known.centre;
  return centre.is_defined &&
         LengthOf(centre.gradient) <= centre.gradient_bound &&
         std::ranges::any_of(levels_, [&](double level) {
           return !centre.light.IsAbove(level) && !centre.light.IsBelow(level);
         });
}

bool LevelGoal::IsSettled(const PlanMesh& mesh, int triangle,
                          const KnownTriangle& known) const {
  const std::array<PlanPoint, 3> corners = mesh.CornersOf(triangle);
  const PlanPoint centre = mesh.CentreOf(triangle);
  if (!HasOneOf(RangeOver(known, centre, corners))) return true;
  const double change = ChangeIn(known);
  if (!(LengthOf(known.centre.gradient) > change)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<PlanPoint, 2> side = {corners[(k + 1) % 3],
                                           corners[(k + 2) % 3]};
    const PlanPoint way = side[1] - side[0];
    if (std::fabs(Dot(known.centre.gradient, way)) > change * LengthOf(way))
      continue;
    if (HasOneOf(RangeOver(known, centre, side))) return false;
  }
  return true;
}

}  // namespace truelux
