// SPDX-License-Identifier: GPL-3.0-or-later
// The printed equations that docs/method.md section 8 corrects: what they give
// as printed, what the corrected ones give, and what is right, by numbers. The
// truth is the oracle's, which uses none of them as printed. Here: directions
// of edges and the tables of terms.

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "radiometry/errata_polygons.h"

namespace truelux::testing {
namespace {

/// A x atan(A y), the term of a vertical edge.
double VerticalTerm(const Image& p) {
  const double a = 1 / std::sqrt(1 + p.x * p.x);
  return a * p.x * std::atan(a * p.y);
}

TEST(Errata, TermsThatMakeVerticalEdgesVanish) {
  const auto sum = [](double sign) {
    return SumOfEdges(kVertical,
                      [sign](const Vector& v, const Vector& w) {
                        const Image p(v);
                        const Image q(w);
                        if (std::fabs(p.x - q.x) < 1e-14) return 0.0;
                        const double a = q.x - p.x;
                        const double b = q.y - p.y;
                        return DirectionTerm(q.x, q.y, a, b) -
                               DirectionTerm(p.x, p.y, a, b) +
                               sign * (VerticalTerm(p) - VerticalTerm(q));
                      }) /
           (2 * pi);
  };
  EXPECT_NEAR(Truth(kVertical), 0.10399550721, kClose);
  EXPECT_NEAR(sum(1), 0.237796303725, kClose);  // (42) as printed
  EXPECT_NEAR(sum(-1), Truth(kVertical), 1e-14);
}

TEST(Errata, RowOfVerticalEdges) {
  const Image p(kVertical[0]);
  const Image q(kVertical[1]);
  const double truth = LambertTerm(kVertical[0], kVertical[1]);
  EXPECT_NEAR(truth, -0.420347599376, kClose);
  // Figures 10 and 11, row 2: in +, out - as printed.
  EXPECT_NEAR(VerticalTerm(q) - VerticalTerm(p), 0.420347599376, kClose);
  EXPECT_NEAR(VerticalTerm(p) - VerticalTerm(q), truth, 1e-14);
  EXPECT_NEAR(DirectionTerm(q.x, q.y, 0, 1) - DirectionTerm(p.x, p.y, 0, 1),
              truth, 1e-14);
  // The example of section 6.2, printed without squares and sign.
  const double root = std::sqrt(1 + p.x);
  EXPECT_NEAR(p.x / root * (std::atan(q.y / root) - std::atan(p.y / root)),
              0.356789218584, kClose);
}

TEST(Errata, FactorsOfTheDirectionTerm) {
  const auto printed = [](double x, double y, double a, double b) {
    const double s = std::sqrt(a * a + b * b + std::pow(b * x - a * y, 2));
    return (a * x + b * y) / s * std::atan((a * y - b * x) / s);
  };
  const auto sum = [](const auto& term) {
    return SumOfEdges(kPolygon,
                      [&term](const Vector& v, const Vector& w) {
                        const Image p(v);
                        const Image q(w);
                        return term(q.x, q.y, q.x - p.x, q.y - p.y) -
                               term(p.x, p.y, q.x - p.x, q.y - p.y);
                      }) /
           (2 * pi);
  };
  EXPECT_NEAR(sum(printed), 0.149141943079, kClose);
  EXPECT_NEAR(sum(DirectionTerm), Truth(kPolygon), 1e-14);
}

/// Row 3 of Figures 10 and 11 for kOneAtInfinity: `out` is the sign at the edge
/// that leaves it, with its direction of travel; `finite` whether C is that of
/// the finite point.
double WithInfinity(double out, bool finite) {
  return SumOfEdges(
             kOneAtInfinity,
             [&](const Vector& v, const Vector& w) {
               const Image p(v);
               const Image q(w);
               const auto far = [finite](const Image& at, double a, double b) {
                 const double k = a * at.y - b * at.x;
                 return pi / 2 * k /
                        std::sqrt(a * a + b * b + (finite ? k * k : 0));
               };
               if (q.infinite) {
                 return far(p, q.x, q.y) - DirectionTerm(p.x, p.y, q.x, q.y);
               }
               if (p.infinite) {
                 return DirectionTerm(q.x, q.y, -p.x, -p.y) +
                        out * far(q, -p.x, -p.y);
               }
               const double a = q.x - p.x;
               const double b = q.y - p.y;
               return DirectionTerm(q.x, q.y, a, b) -
                      DirectionTerm(p.x, p.y, a, b);
             }) /
         (2 * pi);
}

TEST(Errata, VertexAtInfinity) {
  EXPECT_NEAR(Truth(kOneAtInfinity), 0.115701626159, kClose);
  EXPECT_NEAR(WithInfinity(-1, true), -0.135076787764, kClose);
  EXPECT_NEAR(WithInfinity(1, false), 0.164415828582, kClose);
  EXPECT_NEAR(WithInfinity(1, true), Truth(kOneAtInfinity), 1e-14);
}

TEST(Errata, EdgeAtInfinity) {
  const Polygon seen =
      SumOfEdges(kAcross, LambertTerm) > 0 ? kAcross : Reversed(kAcross);
  EXPECT_NEAR(Truth(seen), 0.135671799531, kClose);
  for (const auto& [polygon, correction] :
       {std::pair(seen, pi), std::pair(Reversed(seen), -pi)}) {
    // The edge at infinity: Lambert's term, the angle with its sign.
    double truth = 0;
    double table = 0;    // Figure 10, row 4, without a correction
    double no_bars = 0;  // Figure 11, row 4
    double bars = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector& p = polygon[i];
      const Vector& q = Next(polygon, i);
      if (p.z != 0 || q.z != 0) continue;
      truth = LambertTerm(p, q);
      table = std::atan(q.x / q.y) - std::atan(p.x / p.y);
      const double a = p.x - q.x;  // against the direction of travel
      const double b = p.y - q.y;
      const double k = a * q.y - b * q.x;
      const auto along = [&](const Vector& v) { return a * v.x + b * v.y; };
      no_bars = std::atan(along(q) / k) - std::atan(along(p) / k);
      bars = std::atan(along(q) / std::fabs(k)) -
             std::atan(along(p) / std::fabs(k));
    }
    EXPECT_NEAR(std::fabs(truth), 1.02224692434, kClose);
    EXPECT_NEAR(table + correction, truth, 1e-14);
    EXPECT_NEAR(no_bars, truth, 1e-14);
    // With bars the sign is that of the stored direction, not of the edge.
    EXPECT_NEAR(std::fabs(bars), std::fabs(truth), 1e-14);
    EXPECT_NEAR(bars, correction > 0 ? -truth : truth, 1e-14);
  }
}

TEST(Errata, UnitsOfVertexTracing) {
  // SR (2) sums to 2 pi I / M, and (6) with (7) to pi I / M.
  EXPECT_NEAR(SumOfEdges(kPolygon, LambertTerm), 0.836290063124, kClose);
  EXPECT_NEAR(pi * Truth(kPolygon), 0.418145031562, kClose);
}

}  // namespace
}  // namespace truelux::testing
