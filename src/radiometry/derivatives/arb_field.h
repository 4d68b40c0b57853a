// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of sources at any precision, as enclosures.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_ARB_FIELD_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_ARB_FIELD_H_

#include <cstddef>
#include <vector>

#include "exact/arb_real.h"
#include "radiometry/derivatives/field.h"
#include "radiometry/derivatives/moving_contour.h"

namespace truelux {

/// One arc at a precision.
class ArbArc {
 public:
  ArbArc(const MovingArc& arc, slong precision);

  /// m_out, the unit normal of the arc's plane that points out of the visible
  /// side.
  [[nodiscard]] const Vec3<ArbReal>& outward() const { return outward_; }

  /// The angle of the arc.
  [[nodiscard]] const ArbReal& angle() const { return angle_; }

  /// The integral of w (w . y) over the arc, w the unit directions.
  [[nodiscard]] Vec3<ArbReal> Moment(const Vec3<ArbReal>& y) const;

  /// The integral of w / rho over the arc, rho the distance of its line.
  [[nodiscard]] Vec3<ArbReal> InverseDistances() const;

  /// N / |N|, and N.N.
  [[nodiscard]] const Vec3<ArbReal>& normal() const { return normal_; }

  [[nodiscard]] const ArbReal& square() const { return square_; }

 private:
  const MovingArc& arc_;
  slong precision_;
  Vec3<ArbReal> normal_;
  ArbReal square_;
  Vec3<ArbReal> outward_;
  ArbReal angle_;
  Vec3<ArbReal> first_;   ///< w at the beginning
  Vec3<ArbReal> last_;    ///< w at the end
  Vec3<ArbReal> before_;  ///< N^ x w at the beginning
  Vec3<ArbReal> after_;   ///< N^ x w at the end
};

/// The fields of all sources with M = 1 W/m^2, by the sums over arcs of
/// docs/derivatives.md (2) and (3). source_count: the contour's.
std::vector<Field<ArbReal>> ArbFieldsOf(const MovingContour& contour,
                                        std::size_t source_count,
                                        slong precision);

/// 0 in every component.
Field<ArbReal> NoField(slong precision);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_ARB_FIELD_H_
