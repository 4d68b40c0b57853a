// The planes and directions of a contour as balls, each evaluated once.

#ifndef TRUELUX_RADIOMETRY_BALL_GEOMETRY_H_
#define TRUELUX_RADIOMETRY_BALL_GEOMETRY_H_

#include <optional>
#include <vector>

#include "exact/ball_recipe.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// A plane through r and what every arc in it needs.
template <class T>
struct BallPlane {
  ScaledVector<T> normal;  ///< N
  Ball<T> length;          ///< |N|
  Ball<T> cosine;          ///< n.N / (|n| |N|)
  Vec3<Ball<T>> ascent;    ///< n x N; only with Formula::kHomogeneous
};

/// All planes and directions of one contour at one number type.
///
/// A vector that the balls leave uncertain (near-parallel planes that cross,
/// coordinates at the ends of the exponent range) is evaluated exactly and
/// rounded once, so that it costs no more than the others.
template <class T>
class BallGeometry {
 public:
  BallGeometry(const WeightedContour& contour, Formula formula);

  [[nodiscard]] const ScaledVector<T>& receiver_normal() const {
    return receiver_normal_;
  }

  [[nodiscard]] const BallPlane<T>& Plane(int i) const {
    return planes_[static_cast<std::size_t>(i)];
  }

  [[nodiscard]] const Vec3<Ball<T>>& Direction(int i) const {
    return directions_[static_cast<std::size_t>(i)].vector;
  }

  /// |d1 x d2| / |N| times |N|, from |N| alone, for an arc that is a whole
  /// scene edge; nothing for any other arc.
  [[nodiscard]] std::optional<Ball<T>> CrossOfWholeEdge(const Arc& arc) const;

 private:
  ScaledVector<T> EvaluatePlane(const PlaneRecipe& recipe) const;
  ScaledVector<T> EvaluateDirection(const DirectionRecipe& recipe) const;
  [[nodiscard]] BallPlane<T> Complete(const ScaledVector<T>& normal,
                                      const Ball<T>& receiver_length,
                                      Formula formula) const;

  const WeightedContour& contour_;
  RecipeEvaluator<Ball<T>> recipes_;
  RecipeEvaluator<Exact> exact_recipes_;
  ScaledVector<T> receiver_normal_;
  std::vector<BallPlane<T>> planes_;
  std::vector<ScaledVector<T>> directions_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_BALL_GEOMETRY_H_
