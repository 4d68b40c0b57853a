// SPDX-License-Identifier: GPL-3.0-or-later
// The printed equations that docs/method.md section 8 corrects: what they give
// as printed, what the corrected ones give, and what is right, by numbers. The
// truth is the oracle's, which uses none of them as printed. Here: Lambert's
// formula, the image plane and the sphere.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/errata_polygons.h"

namespace truelux::testing {
namespace {

TEST(Errata, ConstantOfLambertAndOfTheVertexForm) {
  const double sum = SumOfEdges(kPolygon, LambertTerm);
  EXPECT_NEAR(Truth(kPolygon), 0.133099697405, kClose);
  EXPECT_NEAR(sum / pi, 0.26619939481, kClose);         // (3), (13) as printed
  EXPECT_NEAR(sum / (2 * pi), Truth(kPolygon), 1e-14);  // M / 2 pi
}

TEST(Errata, AnglesAreToTheInwardNormal) {
  // Heitz (1) has the opposite order of vertices.
  EXPECT_NEAR(SumOfEdges(Reversed(kPolygon), LambertTerm) / (2 * pi),
              -Truth(kPolygon), 1e-14);
}

TEST(Errata, FrontFacingIsNoMatterOfTheAngleOfNormals) {
  // The plane through (1, 0, 0.5) with normal (-1, 0, 0.3), which has a
  // positive product with z and faces r = 0.
  const Vector n = {-1, 0, .3};
  EXPECT_GT(n.z, 0);
  EXPECT_NEAR(Dot(n, {-1, 0, -.5}), .85, 1e-15);
  const Polygon square = {
      {.985, .1, .45}, {1, .1, .5}, {1, -.1, .5}, {.985, -.1, .45}};
  for (const Vector& v : square)
    EXPECT_NEAR(Dot(n, v - Vector{1, 0, .5}), 0, 1e-15);
  EXPECT_GT(Truth(square) + Truth(Reversed(square)), 1e-4);
}

TEST(Errata, BoundOfLemmaOne) {
  // M int from 1 + R^2 of du / u^2, not twice that; by the midpoint rule.
  const double r = 3;
  double outside = 0;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + .5) / kSteps;  // radius r / t
    const double rho = r / t;
    outside += 2 * rho / std::pow(1 + rho * rho, 2) * r / (t * t) / kSteps;
  }
  EXPECT_NEAR(outside, .1, 1e-9);
  EXPECT_NEAR(1 / (1 + r * r), .1, 1e-15);
}

/// Rotations about an axis by a right-handed angle.
Vector RotatedZ(double t, const Vector& v) {
  return {std::cos(t) * v.x - std::sin(t) * v.y,
          std::sin(t) * v.x + std::cos(t) * v.y, v.z};
}

Vector RotatedY(double t, const Vector& v) {
  return {std::cos(t) * v.x + std::sin(t) * v.z, v.y,
          -std::sin(t) * v.x + std::cos(t) * v.z};
}

TEST(Errata, SenseOfTheRotationByAlpha) {
  // The x axis is to go to (cos phi cos alpha, sin phi cos alpha, sin alpha).
  const double phi = .7;
  const double alpha = .4;
  const Vector x = {1, 0, 0};
  EXPECT_NEAR(RotatedZ(phi, RotatedY(-alpha, x)).z, std::sin(alpha), 1e-15);
  EXPECT_NEAR(RotatedZ(phi, RotatedY(alpha, x)).z, -std::sin(alpha), 1e-15);
}

/// Longitude, latitude and the angle with the meridian at v of an edge.
struct Meridian {
  Meridian(const Vector& v, const Vector& normal)
      : phi(std::atan2(v.y, v.x)),
        alpha(std::atan2(v.z, std::hypot(v.x, v.y))) {
    const Vector n = (1 / truelux::testing::Length(normal)) * normal;
    sin_chi = n.z * std::cos(alpha) -
              (n.x * std::cos(phi) + n.y * std::sin(phi)) * std::sin(alpha);
    cos_chi = n.x * std::sin(phi) - n.y * std::cos(phi);
  }

  double phi;
  double alpha;
  double sin_chi = 0;
  double cos_chi = 0;
};

TEST(Errata, ArcLengthFromTheNode) {
  const Vector& v = kPolygon[0];
  const Vector& w = kPolygon[1];
  const Meridian p(v, Cross(v, w));
  const Meridian q(w, Cross(v, w));
  // (24): sin psi = cos chi, cos psi = sin chi.
  const auto angle = [](const Meridian& m, double square) {
    return std::acos(std::cos(m.alpha) * m.cos_chi /
                     std::sqrt(std::pow(std::sin(m.alpha), 2) * square +
                               m.cos_chi * m.cos_chi));
  };
  const double beta = std::atan2(Length(Cross(v, w)), Dot(v, w));
  EXPECT_NEAR(beta, 1.01554507876, kClose);
  EXPECT_NEAR(angle(q, q.cos_chi * q.cos_chi) - angle(p, p.cos_chi * p.cos_chi),
              0.968797619412, kClose);
  EXPECT_NEAR(angle(q, q.sin_chi * q.sin_chi) - angle(p, p.sin_chi * p.sin_chi),
              beta, 1e-13);
}

/// (27) with (28): `east` is the sign of phi for an eastward edge along the
/// equator, c the count of turns.
double SphereSum(const Polygon& polygon, double east, double c) {
  const auto in_turn = [](double phi) { return phi < 0 ? phi + 2 * pi : phi; };
  const double sum = SumOfEdges(polygon, [&](const Vector& v, const Vector& w) {
    const Meridian p(v, Cross(v, w));
    const Meridian q(w, Cross(v, w));
    if (v.z == 0 && w.z == 0) {
      const bool eastward = Cross(v, w).z > 0;
      return (eastward ? east : -1) * (in_turn(q.phi) - in_turn(p.phi));
    }
    const auto g = [](const Meridian& m) {
      const double angle = m.alpha == 0
                               ? std::copysign(pi / 2, m.cos_chi)
                               : std::atan(m.cos_chi / std::tan(m.alpha));
      return std::cos(m.alpha) * m.sin_chi * angle;
    };
    return g(q) - g(p);
  });
  return c + sum / (2 * pi);
}

TEST(Errata, EquatorEastwardHasTheSameSign) {
  const Polygon polygon = OnPlane(
      {{1, .2, 0}, {.5, .1, .6}, {.4, .7, .7}, {.8, .9, 0}}, {1, 0, .4});
  const double truth = Truth(polygon);
  EXPECT_NEAR(truth, 0.0676357839816, kClose);
  EXPECT_NEAR(SphereSum(polygon, -1, 0), truth, 1e-14);
  // Reversed, the result must be -I.
  EXPECT_NEAR(SphereSum(Reversed(polygon), 1, 0), 0.138233817071, kClose);
  EXPECT_NEAR(SphereSum(Reversed(polygon), -1, 0), -truth, 1e-14);
}

TEST(Errata, TurnsCountEdgesThatStartAtTheMeridian) {
  const Polygon polygon = OnPlane(
      {{1, 0, 0}, {1, -.6, 0}, {.5, -.4, .6}, {.4, .5, .7}}, {.9, .05, .4});
  const Polygon seen =
      SumOfEdges(polygon, LambertTerm) > 0 ? polygon : Reversed(polygon);
  EXPECT_NEAR(Truth(seen), 0.113627342709, kClose);
  EXPECT_NEAR(SphereSum(seen, -1, 0), -0.886372657291, kClose);
  EXPECT_NEAR(SphereSum(seen, -1, 1), Truth(seen), 1e-14);
}

TEST(Errata, CosineOfAnEdgeFromTwoOfItsPoints) {
  const double x = .3;
  const double y = .7;
  const double m = 1.3;
  const double t = .4;
  const auto cosine = [&](double sign) {
    const double third = x * (y + m * t) + sign * y * (x + t);
    return t * (y - m * x) / std::sqrt(m * m * t * t + t * t + third * third);
  };
  EXPECT_NEAR(cosine(1), 0.114975799005, kClose);
  EXPECT_NEAR(cosine(-1), 0.185721996518, kClose);
  EXPECT_NEAR(cosine(-1),
              (y - m * x) / std::sqrt(1 + m * m + std::pow(m * x - y, 2)),
              1e-15);
}

TEST(Errata, SlopeOfTheEdgeItself) {
  std::vector<Image> q;
  for (const Vector& v : kPolygon)
    q.emplace_back(v);
  const auto slope = [&](std::size_t i) {
    return (q[i + 1].y - q[i].y) / (q[i + 1].x - q[i].x);
  };
  const auto angle = [](const Image& p, double m) {
    return std::atan((p.x + m * p.y) /
                     std::sqrt(1 + m * m + std::pow(p.y - m * p.x, 2)));
  };
  // The first edge runs towards smaller x. (38)
  EXPECT_NEAR(-(angle(q[1], slope(1)) - angle(q[0], slope(0))), 0.115680919305,
              kClose);
  EXPECT_NEAR(-(angle(q[1], slope(0)) - angle(q[0], slope(0))), 1.01554507876,
              kClose);
}

}  // namespace
}  // namespace truelux::testing
