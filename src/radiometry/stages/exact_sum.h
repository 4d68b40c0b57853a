// SPDX-License-Identifier: GPL-3.0-or-later
// What an irradiance is a sum of, with everything that is rational in it
// exact: the input of the multiprecision stage, whether the terms come from
// the arcs of a contour or from the spans around vertices.

#ifndef TRUELUX_RADIOMETRY_STAGES_EXACT_SUM_H_
#define TRUELUX_RADIOMETRY_STAGES_EXACT_SUM_H_

#include <array>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// A plane through r with the normal N, beside the receiver's normal n.
struct ExactPlane {
  Exact normal_square;  ///< N.N
  Exact cosine_part;    ///< n.N
  Exact both_squares;   ///< (N.N) (n.n)
};

/// Index into ExactSum::planes.
using ExactPlaneId = Id<struct ExactPlaneTag>;

/// sign * c * atan2(y, x), c = n.N / (|n| |N|) of the term's plane or 1; one
/// of y and x is to be multiplied by |N|.
struct ExactTerm {
  ExactPlaneId plane;
  Exact y;
  Exact x;
  bool length_on_y = false;  ///< whether it is y or x that |N| goes to
  bool has_cosine = true;    ///< whether c is the cosine, or 1
  bool negative = false;
};

/// Terms with one weight.
struct WeightedTerms {
  /// Per channel M [W/m^2], or L [W/m^2/sr], or a difference of two.
  std::array<Exact, 3> weight;
  std::vector<ExactTerm> terms;
};

/// 2 pi E (2 E if the weights are radiances) = the sum of weight times terms.
struct ExactSum {
  IdVector<ExactPlaneId, ExactPlane> planes;
  std::vector<WeightedTerms> groups;
};

/// n_square: n.n.
ExactPlane ExactPlaneOf(const Vec3<Exact>& n, const Exact& n_square,
                        const Vec3<Exact>& normal);

/// H(d, N), what an edge in the plane N adds at its end d if the light is on
/// the side of d x (its other end) [docs/method.md (11)]; requires n.d >= 0.
///
/// ascent: n x N.
ExactTerm EndTerm(ExactPlaneId plane, const Vec3<Exact>& n,
                  const Vec3<Exact>& ascent, const Vec3<Exact>& d,
                  bool negative);

/// The same for an edge in the receiver plane [docs/method.md (12)]: half of
/// what it adds, atan2((d - other).d, |d x other|), which is negative if the
/// light is below the receiver plane.
///
/// across: |d x other| |N|.
ExactTerm HorizonEndTerm(ExactPlaneId plane, const Vec3<Exact>& d,
                         const Vec3<Exact>& other, const Exact& across,
                         bool negative);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_EXACT_SUM_H_
