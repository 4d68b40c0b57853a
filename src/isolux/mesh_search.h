// SPDX-License-Identifier: GPL-3.0-or-later
// Halves triangles of a surface until what is known about each is enough.

#ifndef TRUELUX_ISOLUX_MESH_SEARCH_H_
#define TRUELUX_ISOLUX_MESH_SEARCH_H_

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
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
  bool is_settled = false;  ///< whether the last goal is reached in it
  bool is_dark = false;     ///< whether E is proven to be 0 all over it
};

/// When the search ends.
struct SearchLimits {
  double smallest = 0;  ///< sides are not halved below it [length]
  double plateau = 0;   ///< nor below this one where the goal says IsFlat
  std::size_t most_triangles = 0;
};

/// Values of E [W/m^2].
struct ValueRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void Take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// E on the convex hull of some points of a known triangle around its centre.
ValueRange RangeOver(const KnownTriangle& known, const PlanPoint& centre,
                     std::span<const PlanPoint> points);

/// By how much the gradient in a known triangle may differ from the centre's.
inline double ChangeIn(const KnownTriangle& known) {
  return known.change.Over(known.radius) + known.centre.gradient_bound;
}

/// What is to be known of every triangle. May be asked from several threads.
class SearchGoal {
 public:
  SearchGoal() = default;
  virtual ~SearchGoal() = default;
  SearchGoal(const SearchGoal&) = delete;
  SearchGoal& operator=(const SearchGoal&) = delete;

  /// The change of the gradient [W/m^3] beyond which a triangle with this centre
  /// and radius cannot be settled.
  [[nodiscard]] virtual double UsefulChange(
      const KnownTriangle& known) const = 0;

  /// Whether halving a triangle with this centre is idle, since E is all the
  /// same around it.
  [[nodiscard]] virtual bool IsFlat(const KnownTriangle& /*known*/) const {
    return false;
  }

  /// Whether enough is known.
  [[nodiscard]] virtual bool IsSettled(const PlanMesh& mesh, int triangle,
                                       const KnownTriangle& known) const = 0;
};

/// The search over one mesh. Copies go on by themselves.
class MeshSearch {
 public:
  MeshSearch(const LightProbe& probe, const LightFeatures& features,
             PlanMesh mesh);

  /// Halves all triangles until no side is longer.
  void RefineTo(double longest);

  /// Halves these triangles, and others that must be. Returns what they became.
  std::vector<int> Halve(const std::vector<int>& triangles);

  /// Finds E at all points of the mesh.
  void SamplePoints(int threads, const Watch& watch);

  /// Halves triangles until all are settled or the limits are reached, and finds
  /// E at all points. The result does not depend on threads. Throws Stopped.
  void Settle(const SearchGoal& goal, const SearchLimits& limits, int threads,
              const Watch& watch);

  /// The same for some triangles, and what becomes of them. Returns those that
  /// are not settled.
  std::vector<int> Settle(const SearchGoal& goal, const SearchLimits& limits,
                          std::vector<int> triangles, int threads,
                          const Watch& watch);

  [[nodiscard]] const PlanMesh& mesh() const { return mesh_; }

  /// At the points of the mesh.
  [[nodiscard]] const std::vector<LightValue>& values() const {
    return values_;
  }

  /// E in a triangle; without ends where nothing is known.
  [[nodiscard]] ValueRange RangeOf(int triangle) const;

  [[nodiscard]] const std::vector<KnownTriangle>& known() const {
    return known_;
  }

 private:
  void Halve(int triangle, std::vector<int>& changed);
  void Know(int triangle, const SearchGoal& goal);
  /// Whether E is 0 in all of a triangle.
  [[nodiscard]] bool IsDark(const KnownTriangle& known,
                            const PlanPoint& centre) const;

  const LightProbe* probe_;
  const LightFeatures* features_;
  PlanMesh mesh_;
  std::vector<LightValue> values_;
  std::vector<KnownTriangle> known_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_MESH_SEARCH_H_
