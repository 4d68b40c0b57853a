// SPDX-License-Identifier: GPL-3.0-or-later
// How far the gradient of irradiance can change over a part of a surface on
// which it has no kink: a proven bound, without asking what is seen.
//
// Let a lamp have the exitance M and the plane of height l over it, l(r) > 0.
// Let z be the height of a point over the surface, rho its distance from the
// receiver r, and n the surface's normal. The lamp gives
//
//     E = (M / pi) integral over the part R of the lamp that is seen of
//             z l(r) / rho^4 dA                         [Lambert; FORMULAS (1)]
//
// With r the gradient changes for four reasons; a bound on each is below, per
// length of the way of r. A point x of an edge that bounds R, before the lamp,
// moves the bound of R so that E changes at the rate
//
//     k = (M / pi) z D / rho^4 . l(x) / l(r) dx
//
// with D the distance of r from the line of the edge [Arvo 1994, section 4; the
// factor l(x) / l(r) takes away what moves with the lamp's own points].
//
//  1. what is under the integral:  (M / pi) z/rho^6 (8 a h + l max(4, 24 h^2 /
//     rho^2 - 4)), the norm of the second derivatives of z l / rho^4, with h the
//     horizontal part of the way to the point, h <= rho, and a = |grad l| <= 1;
//  2. what edges of shadows sweep of it: k (a/l(r) + 4/rho_l), the gradient of
//     z l / rho^4 over itself, at a distance rho_l where the ray meets the lamp;
//  3. how fast an edge sweeps: grad k <= (M / pi) (z/rho^4 (1 + 4 h/rho)
//     l(x)/l(r) + z D/rho^4 l(x) a/l(r)^2);
//  4. where the seen part of an edge ends, at another edge before or behind it:
//     k times how far that end moves along the edge. Two edges of one plane
//     never slide along each other, unless r is in that plane, where the kinks
//     are; of others the end is at V_a / (V_a - V_b) of the edge, with V the
//     volumes over r and the other edge, which are affine in r: extremes over a
//     polygon are at its corners.
//
// Everything is rounded to nearest: terms are sums of positive numbers, so that
// the sum is off by a few 2^-53 of itself for each, and distances are lessened
// by 2^-40 of the scene's size. The bound is enlarged by 2^-20 of itself.

#ifndef TRUELUX_ISOLUX_GRADIENT_CHANGE_H_
#define TRUELUX_ISOLUX_GRADIENT_CHANGE_H_

#include <limits>
#include <span>

#include "isolux/light_features.h"
#include "isolux/plan_frame.h"
#include "isolux/sight.h"

namespace truelux {

/// |g(x) - g(centre)| <= rate |x - centre| + jump for all points x of a polygon.
struct GradientChange {
  double rate = 0;  ///< [W/m^4]; +inf: unbounded
  double jump = 0;  ///< [W/m^3]; likewise

  /// The bound for points at most so far away.
  [[nodiscard]] double Over(double distance) const {
    return rate * distance + jump;
  }
};

/// Where nothing is known.
inline constexpr GradientChange kUnknownChange{
    std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity()};

/// Over the convex hull of some points, which holds the centre. sight: Narrowed
/// to these or more.
/// give_up: if rate times the largest distance between points, and jump, exceed
/// it [W/m^3], kUnknownChange may be returned.
GradientChange GradientChangeOver(const LightFeatures& features,
                                  const Sight& sight,
                                  std::span<const PlanPoint> points,
                                  const PlanPoint& centre, double give_up);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_GRADIENT_CHANGE_H_
