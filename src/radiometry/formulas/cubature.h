// SPDX-License-Identifier: GPL-3.0-or-later
// "cubature": positive Gauss cubature over spherical triangles (docs/method.md
// (17) to (19); not in the papers). For unit vectors a, b, c
//
//   F = -(det(a, b, c) / pi) integral over the flat triangle of p_z / |p|^4
//
// with collapsed coordinates p = (1 - s) a + s (1 - t) b + s t c and n x n
// nodes. All terms are positive, and the determinant is relatively accurate, so
// that nothing cancels in a triangle, however small, thin or low it is.
//
// Truncation: |p|^2 = 1 - y as in series.h, 0 <= y <= Y = (2/3) max D, and y
// has degree 2 in s and in t, so that n x n nodes integrate s p_z q(y) exactly
// for polynomials q up to degree n - 2. With positive weights the error is at
// most twice the error of the best such q for (1 - y)^-2 on [0, Y], times the
// integral of s p_z, which is at most F. In x in [-1, 1], y = (Y / 2)(1 + x):
// (1 - y)^-2 = (2 / Y)^2 (c - x)^-2, c = (2 - Y) / Y, whose Chebyshev series
// has the coefficients 2 g^j [j / (c^2 - 1) + c (c^2 - 1)^(-3/2)],
// g = 1 / (c + sqrt(c^2 - 1)); what follows degree n - 2 is summed.
//
// A triangle whose truncation would be above 2^-54 with 10 nodes is cut into
// four at the middles of its sides; the fan of a region starts at its first
// vertex. Not applicable where that does not end: two ends of an arc opposite
// to each other, or nearly.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_CUBATURE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_CUBATURE_H_

#include <algorithm>
#include <cmath>

#include "radiometry/boundary.h"
#include "radiometry/formulas/gauss_rule.h"
#include "radiometry/formulas/partial_sum.h"

namespace truelux {

/// Unit vectors along the corners of a triangle of a fan, as seen from r, and
/// its determinant: > 0 if it is counter-clockwise.
template <class T>
struct UnitTriangle {
  Vec3<T> a;
  Vec3<T> b;
  Vec3<T> c;
  T determinant{};
};

/// Bound on the relative truncation of n x n nodes, 0 < y <= Y < 1.
inline double CubatureTruncation(double y, int n) {
  const double c = (2 - y) / y;
  const double square = c * c - 1;
  const double g = 1 / (c + std::sqrt(square));
  const int k = n - 2;
  const double power = std::pow(g, k + 1);
  const double sum = power / (1 - g);
  const double weighted = power * (k + 1 - k * g) / ((1 - g) * (1 - g));
  const double tail =
      2 * (weighted / square + c * sum / (square * std::sqrt(square)));
  // Twice, and 1 % for the roundings here and in the corners.
  return 2.02 * (4 / (y * y)) * tail;
}

constexpr double kCubatureGoal = 0x1p-54;

/// Below this even the rule with the fewest nodes does.
constexpr double kLeastSpread = 0x1p-30;

/// 1 - cos of the angle between two unit vectors.
template <class T>
double SpreadOf(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<T> d = b - a;
  const double x = Leading(d.x);
  const double y = Leading(d.y);
  const double z = Leading(d.z);
  return (x * x + y * y + z * z) / 2;
}

/// The sum over the nodes of one rule.
template <class T>
T CubatureSum(const UnitTriangle<T>& triangle, const GaussRule<T>& rule,
              const T& pi) {
  const T one = Make<T>(1);
  T sum = Make<T>(0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const T& s = rule.nodes[i];
    const Vec3<T> base = (one - s) * triangle.a;
    T row = Make<T>(0);
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const T in_c = s * rule.nodes[j];
      const T in_b = s * (one - rule.nodes[j]);
      const Vec3<T> p = base - -(in_b * triangle.b - -(in_c * triangle.c));
      const T square = Dot(p, p);
      row = row + rule.weights[j] * p.z / (square * square);
    }
    sum = sum + rule.weights[i] * s * row;
  }
  return triangle.determinant / pi * sum;
}

/// Adds a triangle to `total`, cut further up to `depth` times.
template <class T>
void AddCubature(const UnitTriangle<T>& triangle, const GaussRules<T>& rules,
                 const T& pi, int depth, PartialSum<T>& total) {
  const double d01 = SpreadOf(triangle.a, triangle.b);
  const double d12 = SpreadOf(triangle.b, triangle.c);
  const double d02 = SpreadOf(triangle.a, triangle.c);
  const double y = std::max(2 * std::max({d01, d12, d02}) / 3, kLeastSpread);
  for (std::size_t i = 0; i < rules.size(); ++i) {
    // Written so that a NaN fits no rule.
    const double truncation =
        y < 0.9 ? CubatureTruncation(y, kGaussSizes[i]) : 1;
    if (!(truncation <= kCubatureGoal)) continue;
    const T term = CubatureSum(triangle, rules[i], pi);
    total.value = total.value + term;
    total.truncation += truncation * UpperMagnitude(term);
    return;
  }
  if (depth == 0 || !std::isfinite(y)) {
    total.applicable = false;
    return;
  }
  // The middle of two unit vectors, and the length of their sum.
  const auto middle = [](const Vec3<T>& u, const Vec3<T>& v, T& length) {
    const Vec3<T> sum = u - -v;
    length = Length(sum);
    return Vec3<T>{sum.x / length, sum.y / length, sum.z / length};
  };
  T l01{};
  T l12{};
  T l02{};
  const Vec3<T> m01 = middle(triangle.a, triangle.b, l01);
  const Vec3<T> m12 = middle(triangle.b, triangle.c, l12);
  const Vec3<T> m02 = middle(triangle.a, triangle.c, l02);
  const T& det = triangle.determinant;
  const UnitTriangle<T> parts[] = {
      {triangle.a, m01, m02, det / (l01 * l02)},
      {m01, triangle.b, m12, det / (l01 * l12)},
      {m02, m12, triangle.c, det / (l02 * l12)},
      {m01, m12, m02, Make<T>(2) * det / (l01 * l12 * l02)}};
  for (const UnitTriangle<T>& part : parts) {
    if (total.applicable) AddCubature(part, rules, pi, depth - 1, total);
  }
}

/// The form factor [1] of a region.
template <class T>
PartialSum<T> Cubature(const Boundary<T>& region, const GaussRules<T>& rules) {
  constexpr int kDepth = 5;
  PartialSum<T> sum{Make<T>(0)};
  for (std::size_t i = 0; i < region.arcs.size(); ++i) {
    const BoundaryArc<T>& arc = region.arcs[i];
    if (IsZero(region.fan[i])) continue;
    AddCubature(
        {Unit(region.vertices.front().point), Unit(region.From(arc).point),
         Unit(region.To(arc).point), region.fan[i]},
        rules, region.pi, kDepth, sum);
    if (!sum.applicable) break;
  }
  return sum;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_CUBATURE_H_
