// SPDX-License-Identifier: GPL-3.0-or-later
// Certified results against an evaluation with 421 digits that shares no
// code, and against each other: two formulas, three ways to write the ends.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "exact/vec3.h"
#include "radiometry/hand_contour.h"
#include "radiometry/random_polygons.h"
#include "radiometry/reference.h"
#include "support/portable_random.h"

namespace truelux::testing {
namespace {

constexpr Rgb kEmission{1, 0.3, 7e5};

EvaluationQuery Certified(Formula formula) {
  return {Method::kCertified, Emission::kExitance, formula};
}

/// Every way to evaluate the view gives the bits of the reference.
void ExpectReferenceBits(const RandomView& view) {
  const Real factor = FormFactor(view.ring, view.position, view.normal);
  for (const Ends ends : {Ends::kNatural, Ends::kCrossings, Ends::kExplicit}) {
    HandContour contour(view.position, view.normal);
    contour.AddConvexPolygon(view.ring, kEmission, ends);
    for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
      const Irradiance result = contour.Evaluate(Certified(formula));
      for (std::size_t c = 0; c < 3; ++c) {
        const Real truth = Real(kEmission[c]) * factor;
        ASSERT_EQ(result.value[c], truth.ToDouble())
            << "ends " << static_cast<int>(ends) << " formula "
            << static_cast<int>(formula);
        ASSERT_LE(Abs(Real(result.value[c]) - truth), Real(result.bound[c]));
      }
      const Statistics& s = result.statistics;
      ASSERT_EQ(s.evaluated_zero + s.evaluated_double +
                    s.evaluated_double_double + s.evaluated_multiprecision,
                1U);
      ASSERT_EQ(s.ties, 0U);
    }
  }
}

class CertifiedOfSize : public ::testing::TestWithParam<double> {};

TEST_P(CertifiedOfSize, EqualsTheReferenceInEveryBit) {
  PortableRandom random(21);
  const double size = GetParam();
  for (int i = 0; i < 120; ++i) {
    ExpectReferenceBits(
        MakeRandomView(random, size, random.Uniform(0.2, 1.5), 0));
  }
}

TEST_P(CertifiedOfSize, EqualsTheReferenceAcrossTheHorizon) {
  PortableRandom random(22);
  const double size = GetParam();
  for (int i = 0; i < 120; ++i) {
    const RandomView view =
        MakeRandomView(random, size, size * random.Uniform(-0.2, 0.5), 0);
    ExpectReferenceBits(i % 2 == 0 ? view : Tilted(view));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, CertifiedOfSize,
                         ::testing::Values(1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10,
                                           1e-12));

TEST(Certified, EqualsTheReferenceFarFromTheOrigin) {
  PortableRandom random(23);
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(10, -random.Uniform(0, 6));
    ExpectReferenceBits(Tilted(
        MakeRandomView(random, size, random.Uniform(-0.1, 1) * size, 1e3)));
  }
}

/// A polygon cut by the edge a-b of something nearer.
struct CutView {
  RandomView view;
  Point3 a;
  Point3 b;
};

Real CutFormFactor(const CutView& cut) {
  const RandomView& view = cut.view;
  std::vector<RealVector> ring;
  for (const Point3& p : view.ring) {
    ring.push_back(Relative(p, view.position));
  }
  const RealVector plane =
      Cross(Relative(cut.a, view.position), Relative(cut.b, view.position));
  return FormFactorOfRing(Clip(ring, plane), ToRealVector(view.normal));
}

void ExpectReferenceBits(const CutView& cut) {
  HandContour contour(cut.view.position, cut.view.normal);
  contour.AddCutPolygon(cut.view.ring, cut.a, cut.b, kEmission);
  const Real factor = CutFormFactor(cut);
  for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
    const Irradiance certified = contour.Evaluate(Certified(formula));
    const Irradiance plain =
        contour.Evaluate({Method::kDouble, Emission::kExitance, formula});
    for (std::size_t c = 0; c < 3; ++c) {
      const Real truth = Real(kEmission[c]) * factor;
      ASSERT_EQ(certified.value[c], truth.ToDouble());
      ASSERT_LE(Abs(Real(plain.value[c]) - truth), Real(plain.bound[c]));
      ASSERT_LE(plain.bound[c], 1e-9 * kEmission[c]);
    }
  }
}

TEST(Certified, ApparentVerticesEqualTheReference) {
  PortableRandom random(24);
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10, -random.Uniform(0, 9));
    CutView cut;
    cut.view = MakeRandomView(random, size, random.Uniform(0.7, 1.5), 0);
    // Through the middle of the ring's first vertex and the others' mean, at
    // half the distance.
    const std::vector<Point3>& ring = cut.view.ring;
    const auto at = [&](double t, const Point3& p, const Point3& q) {
      return Point3{0.5 * ((1 - t) * p.x + t * q.x),
                    0.5 * ((1 - t) * p.y + t * q.y),
                    0.5 * ((1 - t) * p.z + t * q.z)};
    };
    cut.a = at(random.Uniform(0.2, 0.8), ring[0], ring[1]);
    cut.b = at(random.Uniform(0.2, 0.8), ring[0], ring.back());
    ExpectReferenceBits(cut);
    if (HasFatalFailure()) return;
  }
}

// The cut runs along a side at an angle of 2^-30 .. 2^-46: from rounded
// normals its ends would be wrong in all digits.
TEST(Certified, CrossingOfNearlyParallelPlanesEqualsTheReference) {
  for (int k = 30; k <= 46; ++k) {
    CutView cut;
    cut.view.position = {0.125, 0.25, 0};
    cut.view.normal = {0, 0.1, 1};
    cut.view.ring = {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}};
    const double tilt = std::ldexp(1.0, -k);
    // Seen from r, the edge crosses the side y = 1 near its middle.
    cut.a = {0.125 + 0.5, 0.25 + 0.375 - tilt, 0.5};
    cut.b = {0.125 - 0.5, 0.25 + 0.375 + tilt, 0.5};
    ExpectReferenceBits(cut);
    std::swap(cut.a, cut.b);
    ExpectReferenceBits(cut);
    if (HasFatalFailure()) return;
  }
}

// Coordinates times a power of two, normals times another: the same bits,
// and no stage more.
TEST(Certified, ScaleOfCoordinatesDoesNotMatter) {
  const std::vector<Point3> ring = {{-3, 2, 5}, {1, 4, -3}, {6, -1, 4}};
  HandContour plain({1, -1, 0}, {1, 2, 3});
  plain.AddConvexPolygon(ring, {1, 1, 1});
  for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
    const double expected = plain.Evaluate(Certified(formula)).value[0];
    for (const int exponent : {-1074, -1000, -600, -200, 200, 600, 1018}) {
      const double s = std::ldexp(1.0, exponent);
      HandContour contour({s, -s, 0}, {s, 2 * s, 3 * s});
      std::vector<Point3> big;
      for (const Point3& p : ring)
        big.push_back({s * p.x, s * p.y, s * p.z});
      contour.AddConvexPolygon(big, {1, 1, 1});
      const Irradiance result = contour.Evaluate(Certified(formula));
      EXPECT_EQ(result.value[0], expected) << exponent;
      EXPECT_EQ(result.statistics.evaluated_double_double, 1U) << exponent;
      const Irradiance rounded =
          contour.Evaluate({Method::kDouble, Emission::kExitance, formula});
      EXPECT_NEAR(rounded.value[0], expected, 1e-15) << exponent;
      EXPECT_LE(rounded.bound[0], 1e-14) << exponent;
    }
  }
}

// Vectors count up to a positive factor, also far outside binary64.
TEST(Certified, LengthOfExplicitVectorsDoesNotMatter) {
  const RandomView view = [] {
    PortableRandom random(25);
    return MakeRandomView(random, 0.5, 0.3, 0);
  }();
  const Real truth = FormFactor(view.ring, view.position, view.normal);
  for (const double factor : {0x1p1000, 0x1p-1000}) {
    HandContour contour(view.position, view.normal);
    contour.AddConvexPolygon(view.ring, {1, 1, 1}, Ends::kExplicit);
    const Exact cube = Exact(factor) * Exact(factor) * Exact(factor);
    for (Vec3<Exact>& v : contour.contour().explicit_vectors.All())
      v = cube * v;
    for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
      const Irradiance result = contour.Evaluate(Certified(formula));
      EXPECT_EQ(result.value[0], truth.ToDouble());
      EXPECT_EQ(result.statistics.evaluated_double_double, 1U);
    }
  }
}

// A source at the largest coordinates, seen from the other end.
TEST(Certified, DifferencesThatOverflowBinary64AreNoProblem) {
  const double far = 0x1.fp1023;
  HandContour contour({0, 0, -far}, {0, 0, 1});
  contour.AddConvexPolygon(
      {{-far, -far, far}, {-far, far, far}, {far, far, far}, {far, -far, far}},
      {1, 1, 1});
  const Real truth = FormFactor(
      {{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}}, {0, 0, 0}, {0, 0, 1});
  for (const Formula formula : {Formula::kAuto, Formula::kUnified}) {
    EXPECT_EQ(contour.Evaluate(Certified(formula)).value[0], truth.ToDouble());
    const Irradiance plain =
        contour.Evaluate({Method::kDouble, Emission::kExitance, formula});
    EXPECT_LE(Abs(Real(plain.value[0]) - truth), Real(plain.bound[0]));
    EXPECT_EQ(plain.statistics.evaluated_double, 1U);
  }
}

}  // namespace
}  // namespace truelux::testing
