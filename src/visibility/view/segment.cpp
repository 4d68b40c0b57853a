// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/segment.h"

#include <utility>

namespace truelux {

std::optional<ArcPoint> PointOnArc(const Vec3<Exact>& from,
                                   const Vec3<Exact>& to,
                                   const Vec3<Exact>& d) {
  ArcPoint point;
  point.plane = Cross(from, to);
  if (!Dot(point.plane, d).is_zero()) return std::nullopt;
  // d = (weight_from from + weight_to to) / |plane|^2.
  point.weight_from = Dot(Cross(d, to), point.plane);
  point.weight_to = Dot(Cross(from, d), point.plane);
  if (SignOf(point.weight_from) == Sign::kNegative ||
      SignOf(point.weight_to) == Sign::kNegative) {
    return std::nullopt;
  }
  return point;
}

}  // namespace truelux
