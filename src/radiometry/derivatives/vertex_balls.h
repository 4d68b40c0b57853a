// SPDX-License-Identifier: GPL-3.0-or-later
// dE/dv of vertices in double-double with running bounds: the stage that
// answers nearly always.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_BALLS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_BALLS_H_

#include <array>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "exact/ball_vector.h"
#include "radiometry/stages/ball_geometry.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// The derivative by one vertex.
template <class T>
struct VertexBall {
  int number = 0;                       ///< of the vertex in the input
  std::array<BallVector<T>, 3> slopes;  ///< dE/dv per channel [W/m^3]
  /// Whether a component is 0 since no arc moves along that axis, or no source
  /// of the channel has an arc: [channel][axis].
  std::array<std::array<bool, 3>, 3> is_zero{};
  /// Whether the vertex belongs to a face that pierces another one: then there
  /// are more terms than these.
  bool has_cuts = false;
};

/// The vertices of all edges that the contour's arcs lie on, and of the faces
/// that it has cuts of, ascending: sums of docs/derivatives.md (4) with W y in
/// the form (6). What cannot be bounded has a bound that is infinite or NaN.
///
/// contour: of a scene. geometry: is evaluated for the contour.
template <class T>
std::vector<VertexBall<T>> VertexBallsOf(const WeightedContour& contour,
                                         const Scene& scene, Emission emission,
                                         BallGeometry<T>& geometry);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_BALLS_H_
