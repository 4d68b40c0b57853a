// SPDX-License-Identifier: GPL-3.0-or-later
// Visible contours made by hand, without any visibility engine.

#ifndef TRUELUX_TESTS_RADIOMETRY_HAND_CONTOUR_H_
#define TRUELUX_TESTS_RADIOMETRY_HAND_CONTOUR_H_

#include <vector>

#include "truelux/geometry.h"

#include "radiometry/evaluate_weighted.h"
#include "radiometry/weighted_contour.h"

namespace truelux::testing {

/// How the ends of an arc are written down; the numbers are the same.
enum class Ends { kNatural, kCrossings, kExplicit };

/// Owns what a WeightedContour refers to.
class HandContour {
 public:
  HandContour(const Point3& position, const Vector3& normal)
      : position_(position), normal_(normal) {}

  /// The visible region of a convex polygon that nothing hides, clipped by
  /// the receiver plane, as a source of emission M.
  void AddConvexPolygon(const std::vector<Point3>& ring, const Rgb& emission,
                        Ends ends = Ends::kNatural);

  /// The same, intersected with the visible side of another polygon's edge:
  /// only directions with ((a - r) x (b - a)) . d > 0 stay. At least one
  /// vertex must be on each side; the polygon must be above the horizon.
  void AddCutPolygon(const std::vector<Point3>& ring, const Point3& a,
                     const Point3& b, const Rgb& emission);

  [[nodiscard]] WeightedContour Weighted() const {
    return {View(), contour_, weights_};
  }

  [[nodiscard]] Irradiance Evaluate(const EvaluationQuery& evaluation) const {
    return EvaluateWeighted(Weighted(), evaluation);
  }

  Contour& contour() { return contour_; }

 private:
  [[nodiscard]] ReceiverView View() const {
    return {vertices_, {}, position_, normal_};
  }

  /// One directed side of a convex region.
  struct Side {
    PlaneId plane;
    DirectionId from;
    DirectionId to;
  };

  std::vector<VertexId> AddRing(const std::vector<Point3>& ring);
  PlaneId AddPlane(const PlaneRecipe& plane);
  DirectionId AddDirection(const DirectionRecipe& direction);
  [[nodiscard]] Exact SideOf(PlaneId plane, const Vec3<Exact>& d) const;
  [[nodiscard]] Vec3<Exact> DirectionOf(DirectionId id) const;
  [[nodiscard]] Vec3<Exact> PlaneOf(PlaneId id) const;
  void Rewrite(std::vector<Side>& sides, Ends ends);
  void AddSource(const std::vector<Side>& sides, const Rgb& emission);

  Point3 position_;
  Vector3 normal_;
  IdVector<VertexId, Point3> vertices_;
  Contour contour_;
  std::vector<Rgb> weights_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_HAND_CONTOUR_H_
