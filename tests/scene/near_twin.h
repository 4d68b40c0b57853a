// SPDX-License-Identifier: GPL-3.0-or-later
// How a receiver lies to a triangle, with quotients of whole numbers and the
// foot of the perpendicular itself.

#ifndef TRUELUX_TESTS_SCENE_NEAR_TWIN_H_
#define TRUELUX_TESTS_SCENE_NEAR_TWIN_H_

#include <algorithm>
#include <array>
#include <cstddef>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

#include "exact/rational.h"

namespace truelux::testing {

struct NearTwin {
  mpq_class plane;     ///< the squared distance to the plane
  mpq_class foot;      ///< that from the perpendicular's foot to the triangle
  mpq_class distance;  ///< that to the triangle
  int turn = 0;        ///< 0 alike, 1 same side, 2 opposite, 3 across
  bool is_behind = false;
};

inline RationalVector Plus(const RationalVector& a, const RationalVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// The squared distance of a point to a segment from a to b.
inline mpq_class SquaredToSegment(const RationalVector& p,
                                  const RationalVector& a,
                                  const RationalVector& b) {
  const RationalVector along = b - a;
  mpq_class t = Dot(p - a, along) / Dot(along, along);
  t = t < 0 ? mpq_class(0) : t > 1 ? mpq_class(1) : t;
  const RationalVector off = p - Plus(a, t * along);
  return Dot(off, off);
}

inline NearTwin NearTwinOf(const std::array<Point3, 3>& corners,
                           const Receiver& receiver) {
  std::array<RationalVector, 3> c;
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = RationalOf(corners[k]);
  const RationalVector r = RationalOf(receiver.position);
  const RationalVector n = RationalOf(
      Point3{receiver.normal.x, receiver.normal.y, receiver.normal.z});
  const RationalVector m = Cross(c[1] - c[0], c[2] - c[0]);
  const mpq_class height = Dot(m, r - c[0]) / Dot(m, m);
  const RationalVector foot = r - height * m;
  NearTwin twin;
  twin.plane = height * height * Dot(m, m);
  bool is_inside = true;
  twin.foot = SquaredToSegment(foot, c[0], c[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalVector& a = c[k];
    const RationalVector& b = c[(k + 1) % 3];
    twin.foot = std::min(twin.foot, SquaredToSegment(foot, a, b));
    if (Dot(Cross(b - a, foot - a), m) < 0) is_inside = false;
  }
  if (is_inside) twin.foot = 0;
  twin.distance = twin.plane + twin.foot;
  const mpq_class cosine = Dot(n, m);
  twin.turn = cosine == 0                                    ? 3
              : cosine < 0                                   ? 2
              : 4 * cosine * cosine >= Dot(n, n) * Dot(m, m) ? 0
                                                             : 1;
  twin.is_behind = cosine * height < 0;
  return twin;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SCENE_NEAR_TWIN_H_
