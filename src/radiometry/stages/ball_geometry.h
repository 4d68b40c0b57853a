// The planes and directions of a contour as balls, each evaluated once.

#ifndef TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_
#define TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_

#include <vector>

#include "exact/ball_vector.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// A plane through r and what every arc in it needs.
template <class T>
struct BallPlane {
  ScaledVector<T> normal;  ///< N
  Ball<T> length;          ///< |N|
  Ball<T> rise;            ///< n.N / |N|, n the scaled receiver normal
  std::size_t axis = 0;    ///< index k of a largest component of N
  Ball<T> along_axis;      ///< |N_k|
  double sign = 1;         ///< of N_k
  /// The scene edge that it is the plane of, by its vertices; -1: no edge.
  int first_vertex = -1;
  int last_vertex = -1;
};

/// A direction from r.
template <class T>
struct BallDirection {
  ScaledVector<T> scaled;  ///< d, of a length in [2^-22, 12]
  int vertex = -1;         ///< the scene vertex that it is; -1: none
};

/// All planes and directions of one contour at one number type. One object
/// serves any number of contours, one after the other, and keeps its memory.
///
/// A vector that the balls leave uncertain (near-parallel planes that cross,
/// coordinates at the ends of the exponent range) is evaluated exactly and
/// rounded once, so that it costs no more than the others.
template <class T>
class BallGeometry {
 public:
  /// Evaluates the planes and directions of a contour.
  void Evaluate(const WeightedContour& contour);

  /// n, scaled by a power of two.
  [[nodiscard]] const BallVector<T>& receiver_normal() const {
    return receiver_normal_;
  }

  [[nodiscard]] const BallPlane<T>& Plane(int i) const {
    return planes_[static_cast<std::size_t>(i)];
  }

  [[nodiscard]] const BallDirection<T>& Direction(int i) const {
    return directions_[static_cast<std::size_t>(i)];
  }

 private:
  void EvaluatePlane(const WeightedContour& contour, const PlaneRecipe& recipe,
                     ScaledVector<T>& normal) const;
  void EvaluateDirection(const WeightedContour& contour,
                         const DirectionRecipe& recipe,
                         ScaledVector<T>& direction) const;

  BallVector<T> receiver_normal_;
  // As long as the longest contour so far needed them.
  std::vector<BallPlane<T>> planes_;
  std::vector<BallDirection<T>> directions_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_
