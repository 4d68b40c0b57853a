// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices and planes of a contour in the receiver's frame, at a working
// precision from which the number types of the formulas are rounded once.
//
// Letters: r the receiver, n its normal; W the working type; x, y, z the axes
// of the frame, z along n.

#ifndef TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_
#define TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/numeric.h"
#include "radiometry/receiver_frame.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// The working types: Ball<DoubleDouble> for what is rounded to double-double
/// and less, Multiprecision for itself.
///
/// Frame: ReceiverFrame. Points are relative to r, all of one source times one
/// power of two.
template <class W>
class FrameGeometry {
 public:
  /// precision [bits]: of Multiprecision; not looked at otherwise. `contour`
  /// must outlive this object.
  FrameGeometry(const WeightedContour& contour, mpfr_prec_t precision);

  /// A direction of the contour as a point: a scene vertex as it is, any other
  /// direction as the point of the source's plane, so that vertices that are
  /// near each other have a short difference. z is exactly 0 if OnHorizon(id),
  /// and never below.
  [[nodiscard]] Vec3<W> Point(SourceId source, DirectionId id) const;

  /// Point(b) - Point(a): without their rounding if both are scene vertices.
  [[nodiscard]] Vec3<W> Between(SourceId source, DirectionId a,
                                DirectionId b) const;

  /// b - a for scene vertices, scaled as the source's points.
  [[nodiscard]] Vec3<W> Edge(SourceId source, VertexId a, VertexId b) const;

  /// Normal of a plane of the contour, a positive multiple of it; exactly along
  /// z if IsHorizon(id).
  [[nodiscard]] Vec3<W> Plane(PlaneId id) const;

  /// Whether a direction lies in the receiver plane, exactly.
  [[nodiscard]] bool OnHorizon(DirectionId id) const { return on_horizon_[id]; }

  /// Whether a plane is the receiver plane, exactly.
  [[nodiscard]] bool IsHorizon(PlaneId id) const { return is_horizon_[id]; }

  /// det(a, b, c) / (|a| |b| |c|) of directions; relatively accurate however
  /// small it is, with its sign, and 0 if it is 0. In the scene's axes, which
  /// are right-handed as the frame is.
  [[nodiscard]] W UnitDeterminant(DirectionId a, DirectionId b,
                                  DirectionId c) const;

  [[nodiscard]] const WeightedContour& contour() const { return contour_; }

 private:
  /// b - a in the frame, scaled.
  [[nodiscard]] Vec3<W> Scaled(SourceId source, const Point3& a,
                               const Point3& b) const;

  void FindHorizon();
  [[nodiscard]] W OntoPlane(SourceId source, DirectionId id) const;

  WeightedContour contour_;
  mpfr_prec_t precision_;
  ReceiverFrame<W> frame_;
  /// A source's points are times 2^-exponent.
  IdVector<SourceId, int> exponents_;
  IdVector<DirectionId, Vec3<W>> directions_;  ///< in the scene's axes
  IdVector<PlaneId, Vec3<W>> planes_;          ///< in the scene's axes
  IdVector<DirectionId, bool> on_horizon_;
  HorizonPlanes is_horizon_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_
