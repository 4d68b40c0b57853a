// SPDX-License-Identifier: GPL-3.0-or-later
// Contours whose irradiance is known in closed form.

#include <cmath>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "exact/vec3.h"
#include "radiometry/evaluate_weighted.h"
#include "radiometry/hand_contour.h"
#include "support/real.h"

namespace truelux::testing {
namespace {

class ClosedForm : public ::testing::TestWithParam<Formula> {
 protected:
  [[nodiscard]] EvaluationQuery Certified() const {
    return {Method::kCertified, Emission::kExitance, GetParam()};
  }

  [[nodiscard]] EvaluationQuery Radiance() const {
    return {Method::kCertified, Emission::kRadiance, GetParam()};
  }

  [[nodiscard]] EvaluationQuery Double() const {
    return {Method::kDouble, Emission::kExitance, GetParam()};
  }

  /// All three stages against one number.
  void Check(const HandContour& contour, const Real& truth) const {
    const Irradiance certified = contour.Evaluate(Certified());
    EXPECT_EQ(certified.value[0], truth.ToDouble());
    const Irradiance plain = contour.Evaluate(Double());
    EXPECT_LE(Abs(Real(plain.value[0]) - truth), Real(plain.bound[0]));
    EXPECT_LE(plain.bound[0], 1e-14);
    EXPECT_EQ(plain.statistics.evaluated_double, 1U);
  }
};

constexpr Rgb kOne{1, 1, 1};

Real ArcTangent(const Real& x) {
  return Atan2(x, Real(1));
}

TEST_P(ClosedForm, Octant) {
  HandContour contour({0, 0, 0}, {0, 0, 1});
  contour.AddConvexPolygon({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, kOne);
  Check(contour, Real(0.25));
}

// Its sides go on straight below the receiver plane: the region above is the
// octant.
TEST_P(ClosedForm, OctantReachingBelowTheHorizon) {
  HandContour contour({0, 0, 0}, {0, 0, 3});
  contour.AddConvexPolygon({{0, 0, 1}, {0, 1, -0.5}, {1, 0, -0.5}}, kOne);
  Check(contour, Real(0.25));
}

TEST_P(ClosedForm, ClosedBoxFillsTheHemisphere) {
  for (const double floor : {0.0, -1.0}) {
    HandContour contour({0.25, -0.5, 0}, {0, 0, 0.125});
    const Rgb m{1, 3, 0.1};
    contour.AddConvexPolygon({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}},
                             m);
    contour.AddConvexPolygon(
        {{-1, -1, 1}, {1, -1, 1}, {1, -1, floor}, {-1, -1, floor}}, m);
    contour.AddConvexPolygon(
        {{1, -1, 1}, {1, 1, 1}, {1, 1, floor}, {1, -1, floor}}, m);
    contour.AddConvexPolygon(
        {{1, 1, 1}, {-1, 1, 1}, {-1, 1, floor}, {1, 1, floor}}, m);
    contour.AddConvexPolygon(
        {{-1, 1, 1}, {-1, -1, 1}, {-1, -1, floor}, {-1, 1, floor}}, m);
    const Irradiance result = contour.Evaluate(Certified());
    EXPECT_EQ(result.value, m);
    const Irradiance plain = contour.Evaluate(Double());
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LE(std::fabs(plain.value[c] - m[c]), plain.bound[c]);
    }
    const Irradiance radiant = contour.Evaluate(Radiance());
    EXPECT_EQ(radiant.value[0], Real::Pi().ToDouble());
    EXPECT_EQ(radiant.value[1], (Real(3) * Real::Pi()).ToDouble());
    EXPECT_EQ(radiant.value[2], (Real(0.1) * Real::Pi()).ToDouble());
  }
}

TEST_P(ClosedForm, RectangleParallelToTheReceiver) {
  const double a = 0.7;
  const double b = 1.9;
  HandContour contour({0, 0, 0}, {0, 0, 1});
  contour.AddConvexPolygon({{0, 0, 1}, {0, b, 1}, {a, b, 1}, {a, 0, 1}}, kOne);
  const auto half = [](const Real& s, const Real& t) {
    const Real root = Sqrt(Real(1) + s * s);
    return s / root * ArcTangent(t / root);
  };
  Check(contour, (half(Real(a), Real(b)) + half(Real(b), Real(a))) /
                     (Real(2) * Real::Pi()));
}

// Its lower edge lies in the receiver plane.
TEST_P(ClosedForm, RectanglePerpendicularToTheReceiver) {
  const double a = 0.7;
  const double b = 1.9;
  HandContour contour({0, 0, 0}, {0, 0, 1});
  contour.AddConvexPolygon({{0, 1, 0}, {0, 1, b}, {a, 1, b}, {a, 1, 0}}, kOne);
  const Real root = Sqrt(Real(1) + Real(b) * Real(b));
  Check(contour, (ArcTangent(Real(a)) - ArcTangent(Real(a) / root) / root) /
                     (Real(2) * Real::Pi()));
}

// A long arc: close to pi, and an arc of exactly pi.
TEST_P(ClosedForm, HalfHemisphereFromArcsOfPi) {
  HandContour contour({0, 0, 0}, {0, 0, 1});
  Contour& c = contour.contour();
  // The lune y > 0, z > 0: two half circles from (1,0,0) to (-1,0,0).
  c.explicit_vectors = {{Exact(1), Exact(0), Exact(0)},
                        {Exact(-1), Exact(0), Exact(0)},
                        {Exact(0), Exact(1), Exact(0)},
                        {Exact(0), Exact(0), Exact(1)}};
  const DirectionId right =
      c.directions.push_back(DirectionRecipe::Explicit(ExplicitId(0)));
  const DirectionId left =
      c.directions.push_back(DirectionRecipe::Explicit(ExplicitId(1)));
  const PlaneId above =
      c.planes.push_back(PlaneRecipe::Explicit(ExplicitId(2)));
  const PlaneId behind =
      c.planes.push_back(PlaneRecipe::Explicit(ExplicitId(3)));
  c.arcs = {{above, true, right, left, {}}, {behind, true, left, right, {}}};
  c.sources = {{FacetId(0), ArcId(0), 2}};
  const std::vector<Rgb> weights = {kOne};
  const WeightedContour weighted{contour.Weighted().view, c, weights};
  const Irradiance result = EvaluateWeighted(weighted, Certified());
  EXPECT_EQ(result.value, (Rgb{0.5, 0.5, 0.5}));
}

TEST_P(ClosedForm, RadianceOfAnOctant) {
  HandContour contour({0, 0, 0}, {0, 0, 1});
  contour.AddConvexPolygon({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, {1, 2, 0});
  const Irradiance result = contour.Evaluate(Radiance());
  EXPECT_EQ(result.value[0], (Real::Pi() / Real(4)).ToDouble());
  EXPECT_EQ(result.value[1], (Real::Pi() / Real(2)).ToDouble());
  EXPECT_EQ(result.value[2], 0);
  EXPECT_EQ(result.bound[2], 0);
}

INSTANTIATE_TEST_SUITE_P(BothFormulas, ClosedForm,
                         ::testing::Values(Formula::kAuto, Formula::kUnified));

}  // namespace
}  // namespace truelux::testing
