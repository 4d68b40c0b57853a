// SPDX-License-Identifier: GPL-3.0-or-later
// The planes and directions of a contour as balls, each evaluated once.
//
// Letters: r the receiver, n its normal; N the normal of a plane through r, N_k
// its component k; d a direction from r.

#ifndef TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_
#define TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_

#include <cstddef>

#include "base/id_vector.h"
#include "base/ids.h"
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
  /// The scene edge that it is the plane of, by its vertices; none: no edge.
  VertexId first_vertex;
  VertexId last_vertex;
};

/// A direction from r.
template <class T>
struct BallDirection {
  ScaledVector<T> scaled;  ///< d, of a length in [2^-22, 12]
  VertexId vertex;         ///< the scene vertex that it is, if any
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

  /// A plane of the contour.
  [[nodiscard]] const BallPlane<T>& Plane(PlaneId id) const {
    return planes_[id];
  }

  /// A direction of the contour.
  [[nodiscard]] const BallDirection<T>& Direction(DirectionId id) const {
    return directions_[id];
  }

 private:
  void EvaluatePlane(const WeightedContour& contour, const PlaneRecipe& recipe,
                     ScaledVector<T>& normal) const;
  void EvaluateDirection(const WeightedContour& contour,
                         const DirectionRecipe& recipe,
                         ScaledVector<T>& direction) const;

  BallVector<T> receiver_normal_;
  // As long as the longest contour so far needed them.
  IdVector<PlaneId, BallPlane<T>> planes_;
  IdVector<DirectionId, BallDirection<T>> directions_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_BALL_GEOMETRY_H_
