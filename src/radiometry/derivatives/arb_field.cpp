// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/arb_field.h"

namespace truelux {
namespace {

ArbReal Whole(slong precision, long x) {
  return ArbReal(precision, x);
}

Vec3<ArbReal> Unit(const Vec3<ArbReal>& v) {
  const ArbReal inverse = Whole(v.x.precision(), 1) / Sqrt(Dot(v, v));
  return inverse * v;
}

/// w w'^T + w' w^T, times y.
Vec3<ArbReal> Symmetric(const Vec3<ArbReal>& w, const Vec3<ArbReal>& across,
                        const Vec3<ArbReal>& y) {
  return Dot(across, y) * w + Dot(w, y) * across;
}

}  // namespace

ArbArc::ArbArc(const MovingArc& arc, slong precision)
    : arc_(arc), precision_(precision) {
  const Vec3<ArbReal> normal = ArbVector(precision, arc.normal);
  square_ = ArbReal(precision, Dot(arc.normal, arc.normal));
  const ArbReal length = Sqrt(square_);
  normal_ = (Whole(precision, 1) / length) * normal;
  outward_ = arc.outward ? normal_ : -normal_;
  // beta = atan2(t / |N|, d1.d2), t = (d1 x d2).N.
  const Exact t = Determinant(arc.first, arc.last, arc.normal);
  angle_ = Angle(ArbReal(precision, t) / length,
                 ArbReal(precision, Dot(arc.first, arc.last)));
  first_ = Unit(ArbVector(precision, arc.first));
  last_ = Unit(ArbVector(precision, arc.last));
  before_ = Cross(normal_, first_);
  after_ = Cross(normal_, last_);
}

/// W y = beta/2 (y - N^ (N^.y)) - 1/4 [w w'^T + w' w^T] y from end to end.
Vec3<ArbReal> ArbArc::Moment(const Vec3<ArbReal>& y) const {
  const ArbReal quarter = Whole(precision_, 1) / Whole(precision_, 4);
  const ArbReal half = Whole(precision_, 1) / Whole(precision_, 2);
  const Vec3<ArbReal> in_plane = y - Dot(normal_, y) * normal_;
  return (half * angle_) * in_plane - quarter * (Symmetric(last_, after_, y) -
                                                 Symmetric(first_, before_, y));
}

/// 1/rho = w . (L x N) / N^2.
Vec3<ArbReal> ArbArc::InverseDistances() const {
  const Vec3<ArbReal> y = ArbVector(precision_, Cross(arc_.line, arc_.normal));
  return Moment((Whole(precision_, 1) / square_) * y);
}

Field<ArbReal> NoField(slong precision) {
  const ArbReal zero(precision, 0L);
  const Vec3<ArbReal> none{zero, zero, zero};
  return {none, {none, none, none}};
}

std::vector<Field<ArbReal>> ArbFieldsOf(const MovingContour& contour,
                                        std::size_t source_count,
                                        slong precision) {
  std::vector<Field<ArbReal>> fields(source_count, NoField(precision));
  const ArbReal inverse_pi = Whole(precision, 1) / ArbReal::Pi(precision);
  const ArbReal half = inverse_pi / Whole(precision, 2);
  for (const MovingArc& moving : contour.arcs) {
    const ArbArc arc(moving, precision);
    Field<ArbReal>& field = fields[moving.source.index()];
    field.vector = field.vector - (half * arc.angle()) * arc.outward();
    if (moving.kind == ArcLine::kHorizon) continue;
    const Vec3<ArbReal> k = arc.InverseDistances();
    const Vec3<ArbReal> out = inverse_pi * arc.outward();
    field.jacobian[0] = field.jacobian[0] - k.x * out;
    field.jacobian[1] = field.jacobian[1] - k.y * out;
    field.jacobian[2] = field.jacobian[2] - k.z * out;
  }
  return fields;
}

}  // namespace truelux
