// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/receiver_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "radiometry/working_number.h"

namespace truelux {
namespace {

template <class W>
Vec3<W> UnitVector(const Vec3<W>& v) {
  const W length = Sqrt(Dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

template <class W>
const W& At(const Vec3<W>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace

template <class W>
Vec3<W> ScaledNormal(const Vector3& n) {
  const double largest =
      std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  // A component that becomes subnormal loses less than 2^-1074 of the largest.
  const int exponent = -std::ilogb(largest);
  return {FromDouble<W>(std::ldexp(n.x, exponent)),
          FromDouble<W>(std::ldexp(n.y, exponent)),
          FromDouble<W>(std::ldexp(n.z, exponent))};
}

template <class W>
ReceiverFrame<W>::ReceiverFrame(const Vector3& n, mpfr_prec_t precision) {
  const std::array<double, 3> size = {std::fabs(n.x), std::fabs(n.y),
                                      std::fabs(n.z)};
  if (std::ranges::count(size, 0.0) == 2) {
    axis_ = static_cast<int>(std::ranges::max_element(size) - size.begin());
    negative_axis_ = n.x < 0 || n.y < 0 || n.z < 0;
    return;
  }
  const auto least = std::ranges::min_element(size) - size.begin();
  Vec3<W> normal = ScaledNormal<W>(n);
  if constexpr (std::is_same_v<W, Multiprecision>) {
    // Exact numbers of 53 bits are to be divided at the full precision.
    const Multiprecision one(precision, 1.0);
    normal = one * normal;
  }
  n_ = UnitVector(normal);
  const W zero = FromDouble<W>(0);
  // e x n for the axis e that is least along n.
  if (least == 0) u_ = UnitVector<W>({zero, -n_.z, n_.y});
  if (least == 1) u_ = UnitVector<W>({n_.z, zero, -n_.x});
  if (least == 2) u_ = UnitVector<W>({-n_.y, n_.x, zero});
  v_ = Cross(n_, u_);
}

template <class W>
Vec3<W> ReceiverFrame<W>::FromScene(const Vec3<W>& v) const {
  if (axis_ < 0) return {Dot(u_, v), Dot(v_, v), Dot(n_, v)};
  const W& next = At(v, (axis_ + 1) % 3);
  const W& last = At(v, (axis_ + 2) % 3);
  const W& along = At(v, axis_);
  if (negative_axis_) return {last, next, -along};
  return {next, last, along};
}

template Vec3<Ball<DoubleDouble>> ScaledNormal(const Vector3&);
template Vec3<Multiprecision> ScaledNormal(const Vector3&);
template class ReceiverFrame<Ball<DoubleDouble>>;
template class ReceiverFrame<Multiprecision>;

}  // namespace truelux
