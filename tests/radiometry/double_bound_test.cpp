// SPDX-License-Identifier: GPL-3.0-or-later
// Method::kDouble: the bound holds always, and is not far from the error.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "radiometry/hand_contour.h"
#include "radiometry/random_polygons.h"
#include "radiometry/reference.h"

namespace truelux::testing {
namespace {

EvaluationQuery Plain(Formula formula) {
  return {Method::kDouble, Emission::kExitance, formula};
}

class DoubleBound : public ::testing::TestWithParam<Formula> {};

TEST_P(DoubleBound, IsNeverViolated) {
  PortableRandom random(41);
  double tightest = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10, -random.Uniform(0, 12));
    const double offset = i % 3 == 0 ? 1e3 * size : 0;
    const double elevation =
        i % 2 == 0 ? random.Uniform(0.1, 1.5) : size * random.Uniform(-0.2, 1);
    const RandomView view =
        Tilted(MakeRandomView(random, size, elevation, offset));
    const Real truth = FormFactor(view.ring, view.position, view.normal);
    HandContour contour(view.position, view.normal);
    contour.AddConvexPolygon(view.ring, {1, 1, 1},
                             i % 5 == 0 ? Ends::kCrossings : Ends::kNatural);
    const Irradiance result = contour.Evaluate(Plain(GetParam()));
    const Real error = Abs(Real(result.value[0]) - truth);
    ASSERT_LE(error, Real(result.bound[0])) << i;
    ASSERT_GE(result.value[0], 0);
    tightest = std::max(tightest, (error / Real(result.bound[0])).ToDouble());
  }
  RecordProperty("largest_error_over_bound", std::to_string(tightest));
  EXPECT_GT(tightest, 0.01);
}

TEST_P(DoubleBound, IsSmallForOrdinarySources) {
  PortableRandom random(42);
  for (int i = 0; i < 500; ++i) {
    const RandomView view =
        MakeRandomView(random, 1, random.Uniform(0.6, 1.5), 0);
    HandContour contour(view.position, view.normal);
    contour.AddConvexPolygon(view.ring, {1, 1, 1});
    EXPECT_LE(contour.Evaluate(Plain(GetParam())).bound[0], 2e-14);
  }
}

// A triangle of about 1 m from up to 1e140 m: its form factor is far below the
// floor that every operation of a ball adds to the bound.
TEST_P(DoubleBound, HasNoFloorForSourcesFarAway) {
  PortableRandom random(43);
  const Rgb emission = {1e308, 1, 1e-20};
  for (int i = 0; i < 200; ++i) {
    const double distance = std::pow(10, random.Uniform(55, 140));
    const Point3 position = {0, 0, 0};
    const Vector3 normal = {random.Uniform(-1, 1), random.Uniform(-1, 1), 2};
    std::vector<Point3> ring;
    for (int k = 0; k < 3; ++k) {
      const double angle = -2.1 * k + random.Uniform(-0.3, 0.3);
      ring.push_back({std::cos(angle), std::sin(angle), distance});
    }
    const Real truth = FormFactor(ring, position, normal);
    HandContour contour(position, normal);
    contour.AddConvexPolygon(ring, emission);
    for (const Formula formula : {GetParam(), Formula::kDifference}) {
      const Irradiance result = contour.Evaluate(Plain(formula));
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const Real irradiance = truth * Real(emission[channel]);
        if (irradiance <= Real(1e-290)) continue;
        const Real bound(result.bound[channel]);
        ASSERT_LE(Abs(Real(result.value[channel]) - irradiance), bound) << i;
        // Beyond, values lose digits to underflow; sums over vertices lose
        // theirs to cancellation.
        if (distance > 1e130 || formula == Formula::kUnified) continue;
        EXPECT_LE(bound, irradiance * Real(1e-9)) << i << " " << distance;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothFormulas, DoubleBound,
                         ::testing::Values(Formula::kAuto, Formula::kUnified));

}  // namespace
}  // namespace truelux::testing
