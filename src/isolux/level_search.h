// SPDX-License-Identifier: GPL-3.0-or-later
// Halves triangles of a surface until it is proven where levels of irradiance
// are passed, and where not.

#ifndef TRUELUX_ISOLUX_LEVEL_SEARCH_H_
#define TRUELUX_ISOLUX_LEVEL_SEARCH_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "isolux/gradient_change.h"
#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/plan_mesh.h"
#include "isolux/sight.h"
#include "run/watch.h"

namespace truelux {

/// What is known about a triangle that no kink and no jump goes through:
/// |E(x) - value - gradient . (x - centre)| <= rate d^2 / 2 + jump d at a
/// distance d from the centre.
struct KnownTriangle {
  LightSample centre;
  GradientChange change;
  double radius = 0;  ///< the largest distance from the centre
  std::shared_ptr<const Sight> sight;
  bool is_known = false;    ///< whether the above is there
  bool is_settled = false;  ///< whether every level is settled in it
  bool is_dark = false;     ///< whether E is proven to be 0 all over it
};

/// When the search ends.
struct SearchLimits {
  double smallest = 0;  ///< sides are not halved below it [length]
  std::size_t most_triangles = 0;
};

/// The search over one mesh.
///
/// A level is settled in a triangle if the triangle does not have it, or if its
/// contour there is one arc from side to side or none: the gradient keeps to one
/// side of a line, so that there is no closed contour, and along each side E is
/// monotonic or misses the level, so that the corners tell how often the sides
/// are crossed.
class LevelSearch {
 public:
  LevelSearch(const LightProbe& probe, const LightFeatures& features,
              PlanMesh mesh);

  /// Halves all triangles until no side is longer.
  void RefineTo(double longest);

  /// Finds E at all points of the mesh.
  void SamplePoints(int threads, const Watch& watch);

  /// Halves triangles until levels are settled or the limits are reached.
  /// levels: ascending. The result does not depend on threads. Throws Stopped.
  void Settle(std::span<const double> levels, const SearchLimits& limits,
              int threads, const Watch& watch);

  [[nodiscard]] const PlanMesh& mesh() const { return mesh_; }

  /// At the points of the mesh.
  [[nodiscard]] const std::vector<LightValue>& values() const {
    return values_;
  }

  /// E in a triangle is between these [W/m^2]; infinite where nothing is known.
  [[nodiscard]] std::pair<double, double> RangeOf(int triangle) const;

  [[nodiscard]] const std::vector<KnownTriangle>& known() const {
    return known_;
  }

 private:
  void Halve(int triangle, std::vector<int>& changed);
  void Know(int triangle, std::span<const double> levels);
  [[nodiscard]] bool IsSettled(int triangle,
                               std::span<const double> levels) const;

  const LightProbe& probe_;
  const LightFeatures& features_;
  PlanMesh mesh_;
  std::vector<LightValue> values_;
  std::vector<KnownTriangle> known_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LEVEL_SEARCH_H_
