// SPDX-License-Identifier: GPL-3.0-or-later
// Where levels of irradiance are passed, and where not.

#ifndef TRUELUX_ISOLUX_LEVEL_GOAL_H_
#define TRUELUX_ISOLUX_LEVEL_GOAL_H_

#include <span>

#include "isolux/mesh_search.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A level is settled in a triangle if the triangle does not have it, or if its
/// contour there is one arc from side to side or none: the gradient keeps to one
/// side of a line, so that there is no closed contour, and along each side E is
/// monotonic or misses the level, so that the corners tell how often the sides
/// are crossed.
class LevelGoal : public SearchGoal {
 public:
  /// levels: ascending; kept by the caller.
  explicit LevelGoal(std::span<const double> levels) : levels_(levels) {}

  [[nodiscard]] double UsefulChange(const KnownTriangle& known) const override;
  /// A level that is the value of a plateau.
  [[nodiscard]] bool IsFlat(const KnownTriangle& known) const override;
  [[nodiscard]] bool IsSettled(const PlanMesh& mesh, int triangle,
                               const KnownTriangle& known) const override;

 private:
  [[nodiscard]] bool HasOneOf(const ValueRange& range) const;

  std::span<const double> levels_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LEVEL_GOAL_H_
