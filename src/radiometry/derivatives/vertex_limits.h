// SPDX-License-Identifier: GPL-3.0-or-later
// dE/dv on both sides of where a vertex is.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_LIMITS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_LIMITS_H_

#include <array>
#include <vector>

#include "truelux/derivatives.h"

#include "exact/arb_real.h"
#include "radiometry/derivatives/limits.h"
#include "radiometry/derivatives/loose_engine.h"
#include "radiometry/derivatives/moving_contour.h"
#include "radiometry/derivatives/vertex_terms.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// Per channel dE/dv as the sum of terms. weights: per source.
std::array<Vec3<ArbReal>, 3> VertexSums(const MovingContour& contour,
                                        const std::vector<VertexTerm>& terms,
                                        const std::vector<Rgb>& weights,
                                        Emission emission, slong precision);

/// The arcs of a contour and what their sources emit.
struct LitArcs {
  MovingContour contour;
  std::vector<Rgb> weights;  ///< per source

  [[nodiscard]] const Rgb& WeightOf(const MovingArc& arc) const {
    return weights[arc.source.index()];
  }
};

/// Derivatives by vertices that may not have any, from contours with the vertex
/// displaced.
class VertexLimits {
 public:
  /// query: of the receiver, in the scene that `loose` was made from.
  VertexLimits(const LooseEngine& loose, const ContourQuery& query,
               Emission emission);

  /// The slopes of the vertex with a number.
  VertexDerivative At(int number);

 private:
  /// Beside where the vertex is, per channel.
  struct OneSide {
    std::array<ArbReal, 3> step;      ///< E less what it is there
    std::array<ArbReal, 3> slope;     ///< dE/dv along one axis
    std::array<ArbReal, 3> size;      ///< bounds on the sizes of its terms
    std::array<ArbReal, 3> exitance;  ///< of all sources seen here and there
  };

  OneSide SideOf(int number, std::size_t axis, bool right);

  const LooseEngine& loose_;
  ContourQuery query_;
  Emission emission_;
  DisplacedContourBuilder builder_;
  Contour contour_;
  CoordinateRange range_;
  long exponent_;    ///< of a step
  slong precision_;  ///< of sums beside it [bits]
  LitArcs at_rest_;  ///< where nothing is displaced
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_LIMITS_H_
