// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/plan_frame.h"

#include <cmath>
#include <cstddef>

#include "scene/facet_normal.h"

namespace truelux {
namespace {

Vec3<double> UnitOf(const Vec3<double>& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return {v.x / length, v.y / length, v.z / length};
}

Vec3<double> RoundedOf(const RationalVector& v) {
  return {NearestTo(v.x), NearestTo(v.y), NearestTo(v.z)};
}

Vec3<double> PlainOf(const Point3& p) {
  return {p.x, p.y, p.z};
}

RationalVector RationalOf(const Vec3<double>& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

}  // namespace

double LengthOf(const PlanPoint& a) {
  return std::hypot(a.s, a.t);
}

PlanFrame::PlanFrame(const Scene& scene, const SurfaceFrame& frame,
                     bool is_reverse) {
  const int face = is_reverse ? frame.reversed.front() : frame.faces.front();
  normal_ = FacetNormal(
      scene, scene.faces()[static_cast<std::size_t>(face)].first_facet);
  on_face_ = face + 1;
  n_ = UnitOf({normal_.x, normal_.y, normal_.z});
  const Vec3<double> first = RoundedOf(frame.u);
  u_ = UnitOf(first - Dot(first, n_) * n_);
  v_ = Cross(n_, u_);
  const Vec3<double> origin = RoundedOf(frame.origin);
  base_ = Dot(origin, n_) * n_;
}

Point3 PlanFrame::PointAt(const PlanPoint& p) const {
  const Vec3<double> point = base_ + p.s * u_ + p.t * v_;
  return {point.x, point.y, point.z};
}

Vector3 PlanFrame::VectorOf(const PlanPoint& v) const {
  const Vec3<double> vector = v.s * u_ + v.t * v_;
  return {vector.x, vector.y, vector.z};
}

Receiver PlanFrame::ReceiverAt(const PlanPoint& p) const {
  return {PointAt(p), normal_, on_face_};
}

Vec3<double> PlanFrame::PlaceOf(const Point3& p) const {
  return DirectionOf(PlainOf(p) - base_);
}

Vec3<double> PlanFrame::DirectionOf(const Vec3<double>& v) const {
  return {Dot(v, u_), Dot(v, v_), Dot(v, n_)};
}

ExactPlanPoint PlanFrame::ExactPlaceOf(const RationalVector& p) const {
  return {Dot(p, RationalOf(u_)), Dot(p, RationalOf(v_))};
}

PlanPoint PlanFrame::Along(const Vector3& v) const {
  const Vec3<double> w = {v.x, v.y, v.z};
  return {Dot(w, u_), Dot(w, v_)};
}

}  // namespace truelux
