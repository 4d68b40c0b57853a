// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives as q0 + sum of q_i beta_i / |N_i| with rational q0 and q_i, and
// whether such a number is zero.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_EXACT_FORM_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_EXACT_FORM_H_

#include <cstddef>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "exact/vec3.h"
#include "radiometry/derivatives/moving_contour.h"

namespace truelux {

using RationalVector = Vec3<mpq_class>;

/// An exact vector as rationals.
RationalVector RationalVectorOf(const Vec3<Exact>& v);

/// The rational parts of one arc.
struct RationalArc {
  explicit RationalArc(const MovingArc& arc);

  RationalVector normal;  ///< N
  RationalVector line;    ///< L
  RationalVector first;   ///< d1
  RationalVector last;    ///< d2
  mpq_class square;       ///< N.N
  mpq_class across;       ///< t = (d1 x d2).N
  mpq_class along;        ///< d1.d2
  int outward = 1;        ///< 1 if N points out of the visible side, else -1
};

/// A number of this form. Sums are over the arcs that were given.
class ExactForm {
 public:
  /// arcs: must outlive the object.
  explicit ExactForm(const std::vector<RationalArc>& arcs)
      : arcs_(arcs), by_angle_(arcs.size()) {}

  /// Adds weight * factor * x.W y / |N| of an arc, W the integral of w w^T over
  /// it: (c beta / |N| + q) with the rationals of docs/derivatives.md (5).
  void AddMoment(std::size_t arc, const mpq_class& weight,
                 const RationalVector& x, const RationalVector& y);

  /// Adds weight * beta / |N| of an arc.
  void AddAngle(std::size_t arc, const mpq_class& weight) {
    by_angle_[arc] += weight;
  }

  /// Whether the number is zero: true only if it is. By Baker's theorem it is
  /// zero exactly if q0 and the sum of angles both are; angles of different
  /// square classes of N.N are independent. Within a class the test multiplies
  /// the unit numbers of the arcs whose coefficients agree up to their sign,
  /// which finds all zeros that come from symmetry, and might miss others.
  [[nodiscard]] bool IsZero() const;

 private:
  [[nodiscard]] bool AnglesCancel() const;

  const std::vector<RationalArc>& arcs_;
  mpq_class rational_;               ///< q0
  std::vector<mpq_class> by_angle_;  ///< q_i
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_EXACT_FORM_H_
