// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/sphere_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/sphere.h"

#include "support/portable_random.h"
#include "support/real.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

using Number = ShortReal;

/// E / M with 120 digits from s = R / d and c = n . w, by the closed form that
/// cancels (docs/method.md (21)).
Number Truth(const Number& s, const Number& c) {
  if (s <= c) return s * s * c;
  if (c <= -s) return 0;
  const Number k = Sqrt((Number(1) - s) * (Number(1) + s));
  const Number q = Sqrt((s - c) * (s + c));
  return (s * s * c * Atan2(q, -c * k) - k * q + Atan2(q, k)) / Number::Pi();
}

/// The view with exact s and c, everything else rounded once.
SphereView ViewOf(double s, double c) {
  const Number one(1);
  return {s,
          c,
          Sqrt((one - Number(s)) * (one + Number(s))).ToDouble(),
          (Number(s) + Number(c)).ToDouble(),
          (Number(s) - Number(c)).ToDouble(),
          (one + Number(c)).ToDouble()};
}

double RelativeError(double value, const Number& truth) {
  return (Abs(Number(value) - truth) / Abs(truth)).ToDouble();
}

double ErrorAt(double s, double c) {
  return RelativeError(SphereFormFactor(ViewOf(s, c)), Truth(s, c));
}

const std::vector<double>& Sizes() {
  static const std::vector<double> sizes = {
      1 - 1e-14, 1 - 1e-9, 1 - 1e-6, 0.999, 0.99, 0.95, 0.9,
      0.86,      0.84,     0.8,      0.7,   0.6,  0.5,  0.3,
      0.1,       0.01,     1e-3,     1e-6,  1e-9, 1e-12};
  return sizes;
}

constexpr double kTolerance = 4e-15;

TEST(SphereFormFactor, AgreesWithTheClosedFormInManyDigits) {
  PortableRandom random(1);
  for (const double s : Sizes()) {
    double worst = 0;
    const double k = ViewOf(s, 0).k;
    for (int i = 0; i < 3000; ++i) {
      double c = s * random.Uniform(-1, 1);
      if (i % 3 == 1) {  // uniform in the angle that chooses the branch
        const double slope = std::tan(random.Uniform(0.01, 1.57)) * k;
        c = -s / std::sqrt(1 + slope * slope);
      } else if (i % 3 == 2) {  // close to the horizon
        c = s * (1 - std::pow(10, random.Uniform(-12, 0)));
        if (random.OneIn(2)) c = -c;
      }
      if (c <= -s) continue;
      worst = std::max(worst, ErrorAt(s, c));
    }
    EXPECT_LT(worst, kTolerance) << "s = " << s;
  }
}

TEST(SphereFormFactor, AlmostSetDownToTheLastBit) {
  for (const double s : Sizes()) {
    for (const double rest : {1e-2, 1e-4, 1e-8, 1e-12})
      EXPECT_LT(ErrorAt(s, -s * (1 - rest)), kTolerance) << s << ' ' << rest;
    const double last = std::nextafter(-s, 0);
    EXPECT_GT(SphereFormFactor(ViewOf(s, last)), 0);
    EXPECT_LT(ErrorAt(s, last), kTolerance) << s;
    EXPECT_EQ(SphereFormFactor(ViewOf(s, -s)), 0);
    EXPECT_EQ(SphereFormFactor(ViewOf(s, -1)), 0);
  }
}

TEST(SphereFormFactor, AboveTheHorizonItIsAsIfAllLightCameFromTheCenter) {
  for (const double s : Sizes()) {
    EXPECT_EQ(SphereFormFactor(ViewOf(s, 1)), s * s);
    EXPECT_EQ(SphereFormFactor(ViewOf(s, s)), s * s * s);
    const double above = std::min((1 + s) / 2, 1.0);
    EXPECT_EQ(SphereFormFactor(ViewOf(s, above)), s * s * above);
    // Continuous where the horizon begins to cut: the lost part is of order
    // (s - c)^2.
    const double below = std::nextafter(s, 0);
    EXPECT_NEAR(SphereFormFactor(ViewOf(s, below)) / (s * s * s), 1, 1e-15);
  }
}

TEST(SphereFormFactor, ContinuousWhereTheBranchChanges) {
  // Two neighbouring c on both sides of psi = 1.1, for small and large
  // spheres, and two neighbouring s on both sides of 0.85: the function itself
  // changes by less than 1e-13.
  for (const double s : {1e-12, 1e-3, 0.5, 0.84, 0.86, 0.99, 1 - 1e-9}) {
    const double slope = std::tan(1.1) * ViewOf(s, 0).k;
    const double c = -s / std::sqrt(1 + slope * slope);
    double low = SphereFormFactor(ViewOf(s, c));
    for (int i = 1; i <= 8; ++i) {
      const double near = c * (1 - 0x1p-52 * (i - 4));
      EXPECT_NEAR(SphereFormFactor(ViewOf(s, near)) / Truth(s, near).ToDouble(),
                  1, kTolerance);
      EXPECT_LT(ErrorAt(s, c), kTolerance);
      low = std::min(low, SphereFormFactor(ViewOf(s, near)));
    }
    EXPECT_GT(low, 0);
  }
  for (const double c : {-0.01, -0.1, -0.3}) {
    const double low = SphereFormFactor(ViewOf(0.85, c));
    const double high = SphereFormFactor(ViewOf(std::nextafter(0.85, 1), c));
    EXPECT_NEAR(high / low, 1, 2 * kTolerance);
  }
}

TEST(SphereFormFactor, HalfVisible) {
  // c = 0: (asin s - s sqrt(1 - s^2)) / pi.
  for (const double s : Sizes()) {
    const Number root = Sqrt((Number(1) - Number(s)) * (Number(1) + Number(s)));
    const Number half =
        (Atan2(Number(s), root) - Number(s) * root) / Number::Pi();
    EXPECT_LT(RelativeError(SphereFormFactor(ViewOf(s, 0)), half), 2e-15) << s;
  }
}

TEST(SphereFormFactor, TouchingSphereFillsHalfSpace) {
  // d = R: everything on the center's side is lit, (1 + c) / 2.
  for (const double c : {-0.999, -0.5, -1e-3, 0.0, 0.25, 0.999})
    EXPECT_NEAR(SphereFormFactor(ViewOf(1, c)), (1 + c) / 2, 1e-15);
  EXPECT_EQ(SphereFormFactor(ViewOf(1, 1)), 1);
}

/// E / M from the input numbers themselves.
Number TruthOf(const Receiver& r, const Sphere& sphere) {
  const Number x = Number(sphere.center.x) - Number(r.position.x);
  const Number y = Number(sphere.center.y) - Number(r.position.y);
  const Number z = Number(sphere.center.z) - Number(r.position.z);
  const Number nx(r.normal.x);
  const Number ny(r.normal.y);
  const Number nz(r.normal.z);
  const Number d = Sqrt(x * x + y * y + z * z);
  const Number length = Sqrt(nx * nx + ny * ny + nz * nz);
  return Truth(Number(sphere.radius) / d,
               (nx * x + ny * y + nz * z) / (d * length));
}

TEST(Sphere, AnywhereWithANormalOfAnyLength) {
  PortableRandom random(2);
  const auto vector = [&random](double size) {
    return Vector3{random.Uniform(-size, size), random.Uniform(-size, size),
                   random.Uniform(-size, size)};
  };
  int cut = 0;
  for (int i = 0; i < 4000; ++i) {
    const double offset = std::pow(10, random.Uniform(-3, 9));
    const Vector3 p = vector(offset);
    const Vector3 w = vector(3);
    const Receiver receiver{
        {p.x, p.y, p.z}, vector(std::pow(10, random.Uniform(-200, 200))), 0};
    Sphere sphere{{p.x + w.x, p.y + w.y, p.z + w.z}, 0, {1, 2, 0}};
    const double d = std::hypot(sphere.center.x - p.x, sphere.center.y - p.y,
                                sphere.center.z - p.z);
    const int kind = i % 3;
    sphere.radius =
        d * (kind == 0   ? random.Uniform(0.01, 0.99)
             : kind == 1 ? std::pow(10, random.Uniform(-12, 0))
                         : 1 - std::pow(10, random.Uniform(-14, 0)));
    const Number truth = TruthOf(receiver, sphere);
    const Rgb e = IrradianceFromSphere(receiver, sphere);
    if (truth <= Number(0)) {
      EXPECT_EQ(e[0], 0);
      continue;
    }
    ASSERT_LT(RelativeError(e[0], truth), kTolerance) << i;
    EXPECT_EQ(e[1], 2 * e[0]);
    EXPECT_EQ(e[2], 0);
    const Number s = Number(sphere.radius) / Number(d);
    if (truth < s * s * s) ++cut;
  }
  EXPECT_GT(cut, 500);
}

TEST(Sphere, GrazingTheHorizon) {
  // The center is R (1 - t) below the receiver plane: the part of the sphere
  // above it is t R high.
  for (const double t : {1e-1, 1e-4, 1e-8, 1e-12, 0x1p-52}) {
    const Receiver receiver{{0, 0, 0}, {0, 0, 5}, 0};
    const Sphere sphere{{1.5, -2, -(1 - t)}, 1, {1, 1, 1}};
    EXPECT_LT(RelativeError(IrradianceFromSphere(receiver, sphere)[0],
                            TruthOf(receiver, sphere)),
              kTolerance)
        << t;
  }
  const Receiver up{{0, 0, 0}, {0, 0, 1}, 0};
  EXPECT_EQ(IrradianceFromSphere(up, {{1.5, -2, -1}, 1, {1, 1, 1}})[0], 0);
  EXPECT_GT(
      IrradianceFromSphere(up, {{1.5, -2, -1 + 0x1p-53}, 1, {1, 1, 1}})[0], 0);
}

TEST(Sphere, AlmostTouchedByTheReceiver) {
  // d / R - 1 from 1e-3 to a few units in the last place, and 0.
  for (const double gap : {1e-3, 1e-9, 1e-15, 0x1p-52, 0.0}) {
    for (const Vector3& normal : {Vector3{0, 0, 1}, Vector3{1, 0, 0},
                                  Vector3{1, 2, -0.5}, Vector3{1e-5, 0, -1}}) {
      const Receiver receiver{{0, 0, 0}, normal, 0};
      const Sphere sphere{{0, 0, 3 * (1 + gap)}, 3, {1, 1, 1}};
      const double e = IrradianceFromSphere(receiver, sphere)[0];
      const Number truth = TruthOf(receiver, sphere);
      if (truth <= Number(0)) {
        EXPECT_EQ(e, 0);
      } else {
        EXPECT_LT(RelativeError(e, truth), kTolerance) << gap;
      }
    }
  }
  // d^2 = R^2 exactly, though no coordinate says so.
  EXPECT_EQ(IrradianceFromSphere({{1, 1, 1}, {2, 3, 6}, 0},
                                 {{3, 4, 7}, 7, {1, 1, 1}})[0],
            1);
}

TEST(Sphere, PowersOfTwoKeepTheBits) {
  PortableRandom random(3);
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&random] { return random.Uniform(-2, 2); };
    const Point3 p{coordinate(), coordinate(), coordinate()};
    const Vector3 n{coordinate(), coordinate(), coordinate()};
    const Sphere sphere{{p.x + 2, p.y + coordinate(), p.z + coordinate()},
                        random.Uniform(0.5, 1.9),
                        {1, 1, 1}};
    const double e = IrradianceFromSphere({p, n, 0}, sphere)[0];
    for (const int scale : {-900, -300, -1, 7, 500, 1020}) {
      const auto scaled = [scale](const auto& v) {
        auto result = v;
        result.x = std::ldexp(v.x, scale);
        result.y = std::ldexp(v.y, scale);
        result.z = std::ldexp(v.z, scale);
        return result;
      };
      const Sphere other{scaled(sphere.center),
                         std::ldexp(sphere.radius, scale), sphere.exitance};
      EXPECT_EQ(IrradianceFromSphere({scaled(p), n, 0}, other)[0], e) << scale;
      EXPECT_EQ(IrradianceFromSphere({p, scaled(n), 0}, sphere)[0], e);
    }
  }
}

TEST(Sphere, EndsOfTheExponentRange) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Vector3 up{0, 0, 1};
  // The difference overflows: d = 2 huge, R = huge.
  EXPECT_EQ(IrradianceFromSphere({{0, 0, -huge}, up, 0},
                                 {{0, 0, huge}, huge, {4, 0, 0}})[0],
            1);
  EXPECT_EQ(IrradianceFromSphere({{0, 0, 0}, up, 0},
                                 {{0, 0, 2 * tiny}, tiny, {4, 0, 0}})[0],
            1);
  EXPECT_EQ(IrradianceFromSphere({{huge, 0, 0}, {0, 0, tiny}, 0},
                                 {{huge, 0, 1}, 0.5, {4, 0, 0}})[0],
            1);
  EXPECT_EQ(IrradianceFromSphere({{0, 0, 0}, {0, 0, huge}, 0},
                                 {{0, 0, huge}, tiny, {4, 0, 0}})[0],
            0);
}

TEST(Sphere, BadInputIsRefused) {
  const Receiver up{{0, 0, 0}, {0, 0, 1}, 0};
  const Sphere good{{0, 0, 2}, 1, {1, 1, 1}};
  EXPECT_NO_THROW(static_cast<void>(IrradianceFromSphere(up, good)));
  const auto refused = [](const Receiver& receiver, const Sphere& sphere) {
    EXPECT_THROW(static_cast<void>(IrradianceFromSphere(receiver, sphere)),
                 std::invalid_argument);
  };
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({{0, 0, 0}, {0, 0, 0}, 0}, good);
  for (const double bad : {inf, -inf, nan}) {
    refused({{0, bad, 0}, {0, 0, 1}, 0}, good);
    refused({{0, 0, 0}, {bad, 0, 1}, 0}, good);
    refused(up, {{0, bad, 2}, 1, {1, 1, 1}});
    refused(up, {{0, 0, 2}, bad, {1, 1, 1}});
    refused(up, {{0, 0, 2}, 1, {1, bad, 1}});
  }
  refused(up, {{0, 0, 2}, 0, {1, 1, 1}});
  refused(up, {{0, 0, 2}, -1, {1, 1, 1}});
  refused(up, {{0, 0, 2}, 3, {1, 1, 1}});
  refused(up, {{0, 0, 2}, 1e300, {1, 1, 1}});
  refused(up, {{0, 0, 2}, std::nextafter(2, 3), {1, 1, 1}});
  refused(up, {{0, 0, 0}, 1e-300, {1, 1, 1}});
}

/// The sphere with n circles of latitude, corners on its surface, seen from
/// the origin.
double Tessellated(const Sphere& sphere, const Receiver& receiver, int n) {
  const auto corner = [&](int i, int j) {
    const double u = std::numbers::pi * (j % (2 * n)) / n;
    const double v = std::numbers::pi * i / n;
    const double r = i == 0 || i == n ? 0 : sphere.radius * std::sin(v);
    return Point3{sphere.center.x + r * std::cos(u),
                  sphere.center.y + r * std::sin(u),
                  sphere.center.z + sphere.radius * std::cos(v)};
  };
  std::vector<TestFace> faces;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      if (i > 0) {
        faces.push_back({{corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)},
                         sphere.exitance});
      }
      if (i + 1 < n) {
        faces.push_back({{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)},
                         sphere.exitance});
      }
    }
  }
  return Evaluate(MakeScene(faces), receiver)[0];
}

TEST(Sphere, AFineTessellationTendsToIt) {
  const Sphere sphere{{0.5, 0.25, 1}, 1, {3, 0, 0}};
  for (const Vector3& normal :
       {Vector3{0.1, 0, 1}, Vector3{1, 0.5, -0.2}, Vector3{-0.5, 1, -0.4}}) {
    const Receiver receiver{{-1, 0, -0.5}, normal, 0};
    const double e = IrradianceFromSphere(receiver, sphere)[0];
    ASSERT_GT(e, 0);
    const double coarse = 1 - Tessellated(sphere, receiver, 16) / e;
    const double fine = 1 - Tessellated(sphere, receiver, 32) / e;
    EXPECT_GT(fine, 0);  // it lies inside the sphere
    EXPECT_LT(fine, 0.04);
    EXPECT_NEAR(coarse / fine, 4, 1);  // of second order
  }
}

}  // namespace
}  // namespace truelux::testing
