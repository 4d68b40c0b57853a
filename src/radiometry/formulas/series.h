// SPDX-License-Identifier: GPL-3.0-or-later
// "series": a triangle of small angular size as a series of positive terms
// (docs/method.md (17), (18); not in the papers). With unit vectors u_k and
// D_ij = 1 - cos beta_ij,
//
//   F = -det(u_0, u_1, u_2) / (6 pi) sum_k (z.u_k) w_k
//   w_k = 1 + (2/5)(D_ki + D_kj) + (1/5) D_ij + [6 (D_ki^2 + D_kj^2 + D_ki D_kj)
//         + 2 D_ij^2 + 4 D_ij (D_ki + D_kj)] / 35
//
// Truncation: with p = sum l_k u_k on the triangle, |p|^2 = 1 - y, 0 <= y =
// 2 sum l_i l_j D_ij <= Y = (2/3) max D, and the series takes the first three
// terms of the integrand's factor |p|^-4 = sum (m + 1) y^m. What is left is at
// most 4 Y^3 / (1 - Y)^2 of it, pointwise, and so of F, since z >= 0.
//
// A region is a fan of signed triangles from its first vertex. Applicable where
// no two corners of a triangle are more than about 0.1 rad apart. Error in
// arithmetic: a few u of each triangle, whatever its size, shape and elevation,
// as the determinant is relatively accurate.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_SERIES_H_
#define TRUELUX_RADIOMETRY_FORMULAS_SERIES_H_

#include <algorithm>

#include "radiometry/boundary.h"
#include "radiometry/formulas/partial_sum.h"

namespace truelux {

/// 1 - cos of the angle between a and b, b - a = difference.
template <class T>
T OneMinusCosine(const Vec3<T>& a, const Vec3<T>& b,
                 const Vec3<T>& difference) {
  const Vec3<T> normal = Cross(a, difference);
  const T squares = Dot(a, a) * Dot(b, b);
  const T cosine = Dot(a, b) / Sqrt(squares);
  return Dot(normal, normal) / squares / (Make<T>(1) + cosine);
}

/// w of a corner: `near`, `next` are D to the other two, `far` is D of those.
template <class T>
T SeriesWeight(const T& near, const T& next, const T& far) {
  const T both = near + next;
  const T square = near * near + next * next + near * next;
  return Make<T>(1) + (Make<T>(2) * both + far) / Make<T>(5) +
         (Make<T>(6) * square + Make<T>(2) * far * far +
          Make<T>(4) * far * both) /
             Make<T>(35);
}

/// The largest D of a triangle to which the series is applied.
constexpr double kSeriesLimit = 0.005;

/// The form factor [1] of a region.
template <class T>
PartialSum<T> Series(const Boundary<T>& region) {
  PartialSum<T> sum{Make<T>(0)};
  for (std::size_t i = 0; i < region.arcs.size(); ++i) {
    const BoundaryArc<T>& arc = region.arcs[i];
    const T& determinant = region.fan[i];
    if (IsZero(determinant)) continue;
    const BoundaryVertex<T>& first = region.vertices.front();
    const BoundaryVertex<T>& from = region.From(arc);
    const BoundaryVertex<T>& to = region.To(arc);
    const T d01 = OneMinusCosine(first.point, from.point, from.from_first);
    const T d02 = OneMinusCosine(first.point, to.point, to.from_first);
    const T d12 = OneMinusCosine(from.point, to.point, arc.chord);
    const double most = std::max(
        {UpperMagnitude(d01), UpperMagnitude(d02), UpperMagnitude(d12)});
    // Written so that a NaN is too large.
    if (!(most <= kSeriesLimit)) return {Make<T>(0), 0, false};
    const auto height = [](const BoundaryVertex<T>& v) {
      return v.point.z / Length(v.point);
    };
    const T term = determinant / (Make<T>(6) * region.pi) *
                   (height(first) * SeriesWeight(d01, d02, d12) +
                    height(from) * SeriesWeight(d01, d12, d02) +
                    height(to) * SeriesWeight(d02, d12, d01));
    sum.value = sum.value + term;
    const double y = 2 * most / 3;
    sum.truncation +=
        4.01 * y * y * y / ((1 - y) * (1 - y)) * UpperMagnitude(term);
  }
  return sum;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_SERIES_H_
