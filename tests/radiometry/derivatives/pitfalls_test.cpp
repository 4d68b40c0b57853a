// SPDX-License-Identifier: GPL-3.0-or-later
// One test for each mistake that derivatives of irradiance invite, by closed
// forms and identities. docs/derivatives.md says which change of the code each
// of them has been seen to find.

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/rectangle_slopes.h"
#include "radiometry/evaluate.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Rgb kUnit = {1, 1, 1};
constexpr Vector3 kRight = {1, 0, 0};
constexpr Vector3 kLeft = {-1, 0, 0};
constexpr Vector3 kUp = {0, 0, 1};
constexpr Vector3 kDown = {0, 0, -1};
constexpr Receiver kOriginUp = {{0, 0, 0}, {0, 0, 1}, 0};

/// The gradient of the first channel by the arcs at r and Arb alone, which
/// double-double leaves nearly nothing to.
Vector3 GradientByArb(const Scene& scene, const Receiver& receiver) {
  const ContourQuery query{scene, receiver};
  const Contour contour = ContourEngine(scene).Build(query);
  std::vector<Rgb> weights;
  FindWeights(query, contour, weights);
  const auto fields =
      ArbFieldsOf(MovingContourOf(ViewOf(query), contour), weights.size(), 256);
  Field<ArbReal> sum = NoField(256);
  for (std::size_t s = 0; s < fields.size(); ++s)
    AddTimes(fields[s], ArbReal(256, Exact(weights[s][0])), sum);
  const Vec3<ArbReal> n =
      ArbVector(256, RecipeEvaluator<Exact>(ViewOf(query)).ReceiverNormal());
  const auto components = ComponentsOf(sum, sum, n, n);
  const auto middle = [](const ArbReal& x) {
    return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
  };
  return {middle(components[0]), middle(components[1]), middle(components[2])};
}

/// The gradients that every stage gives, which are to be alike.
std::vector<Vector3> GradientsOf(const Scene& scene, const Receiver& receiver) {
  return {Oracle(scene).Derivatives(receiver).channels[0].gradient,
          Oracle(scene, {.method = Method::kDouble})
              .Derivatives(receiver)
              .channels[0]
              .gradient,
          GradientByArb(scene, receiver)};
}

const VertexSlope& SlopeOf(const VertexDerivatives& found, int number,
                           std::size_t axis) {
  static const VertexSlope nothing;
  for (const VertexDerivative& vertex : found.vertices) {
    if (vertex.number == number) return vertex.slopes[0][axis];
  }
  return nothing;
}

/// E'(r; d) as gradient and kinks say.
double OneSided(const Derivatives& derivatives, const Vector3& d) {
  const auto dot = [&d](const Vector3& v) {
    return v.x * d.x + v.y * d.y + v.z * d.z;
  };
  double slope = dot(derivatives.channels[0].gradient);
  for (const Kink& kink : derivatives.kinks)
    slope += kink.size[0] * std::fabs(dot(kink.normal));
  return slope;
}

/// A scene whose faces name their vertices.
class NumberedScene {
 public:
  void Add(const Ring& ring, const Rgb& emission,
           const std::vector<int>& numbers) {
    builder_.SetVertexNumbers(numbers);
    builder_.AddFace(ring, emission);
  }

  Scene Build() { return *builder_.Build().value; }

 private:
  SceneBuilder builder_;
};

/// Half of a lamp is behind a blocker whose left edge is at x, at height 1.
std::vector<TestFace> Penumbra(double x) {
  return {{Ceiling(-2, 2, -1, 1, 2), kUnit}, {Ceiling(x, 3, -4, 4, 1), kBlack}};
}

// An edge that points at the receiver and passes it at 2^-20 m: its nearest
// point is a million times nearer than the arc. What goes through that point
// loses as much again, beside the 2^20 that its normal has lost already.
TEST(Pitfalls, DistancesComeFromTheEndsOfAnArc) {
  constexpr double kNear = 0x1p-20;
  const Scene scene =
      MakeScene({{Ceiling(-1, 1, -1, 1, 2), kUnit},
                 {{{kNear, kNear, 1}, {kNear, kNear, 1.5}, {1, 0.5, 1}}}});
  const Derivatives certified = Oracle(scene).Derivatives(kOriginUp);
  const Derivatives plain =
      Oracle(scene, {.method = Method::kDouble}).Derivatives(kOriginUp);
  ASSERT_EQ(certified.smoothness, Smoothness::kC1);
  const Vector3& g = certified.channels[0].gradient;
  const Vector3& p = plain.channels[0].gradient;
  const Vector3& bound = plain.bounds[0].gradient;
  EXPECT_GT(std::fabs(g.x), 1e-2);
  EXPECT_GT(bound.x, 0);
  EXPECT_LT(bound.x, 0x1p-26);
  EXPECT_LT(bound.y, 0x1p-26);
  EXPECT_LE(std::fabs(g.x - p.x), bound.x);
  EXPECT_LE(std::fabs(g.y - p.y), bound.y);
}

// An edge of a face that is seen edge-on lies on a line through the receiver.
// Beside it that line is some 2^-1000 m away.
TEST(Pitfalls, AStepBesideALineKeepsItsDigits) {
  const Scene scene =
      MakeScene({{Ceiling(-1, 1, -1, 1, 2), kUnit},
                 {{{0, 0, 1}, {0, 1, 1}, {0, 1, 1.5}, {0, 0, 1.5}}, kBlack}});
  const Derivatives d = Oracle(scene).Derivatives(kOriginUp);
  ASSERT_EQ(d.kinks.size(), 1U);
  EXPECT_EQ(d.kinks[0].normal, (Vector3{1, 0, 0}));
  // On either side it hides what is between its edges at heights 1 and 1.5.
  EXPECT_NEAR(d.kinks[0].size[0], -2.0 / 3 * LineSlope(2, 0, 0, 1), 1e-16);
  EXPECT_EQ(d.channels[0].gradient.x, 0);
  EXPECT_EQ(d.channels[0].gradient.y, 0);
}

// V points to the light; E rises towards it.
TEST(Pitfalls, VectorAndJacobianHaveOppositeNormals) {
  const Scene scene = MakeScene({{Ceiling(0.5, 1.5, -1, 1, 2), kUnit}});
  const double slope = LineSlope(2, 0.5, -1, 1) - LineSlope(2, 1.5, -1, 1);
  EXPECT_GT(slope, 0.01);
  for (const Vector3& g : GradientsOf(scene, kOriginUp)) {
    EXPECT_NEAR(g.x, slope, 1e-15);
    EXPECT_NEAR(g.y, 0, 1e-15);
    EXPECT_GT(g.z, 0);
  }
  const Derivatives d = Oracle(scene).Derivatives(kOriginUp);
  EXPECT_EQ(d.channels[0].vector.z, d.irradiance.value[0]);
  EXPECT_GT(d.channels[0].vector.x, 0);
  EXPECT_GT(d.channels[0].normal.x, 0);
}

// Two blockers at heights 1 and 1.5 close a slit as seen from the origin. At
// 2^-70 m beside it no rounded number tells the sides of its edges. E is the
// slope with which it opens times the way.
TEST(Pitfalls, SidesOfASlitAreExact) {
  constexpr double kWay = 0x1p-70;
  const Scene scene = MakeScene({{Ceiling(-2, 4, -1, 1, 2), kUnit},
                                 {Ceiling(-3, 1, -4, 4, 1), kBlack},
                                 {Ceiling(1.5, 6, -6, 6, 1.5), kBlack}});
  const Receiver receiver{{kWay, 0, 0}, {0, 0, 1}, 0};
  // In the lamp's plane the edges are 2 r_x and (4/3) r_x to the left.
  const double slope = LineSlope(2, 2, -1, 1) * (2.0 - 4.0 / 3);
  for (const Vector3& g : GradientsOf(scene, receiver)) {
    EXPECT_NEAR(g.x, slope, 1e-15);
    EXPECT_NEAR(g.y, 0, 1e-15);
  }
  EXPECT_NEAR(Evaluate(scene, receiver)[0] / kWay, slope, 1e-15);
}

// The edge of the shadow moves by the blocker's distance, not by the lamp's.
TEST(Pitfalls, ApparentVertexTakesEachArcsOwnLine) {
  const Scene scene = MakeScene(Penumbra(0.25));
  const double slope = -2 * LineSlope(2, 0.5, -1, 1) + LineSlope(2, -2, -1, 1);
  for (const Vector3& g : GradientsOf(scene, kOriginUp)) {
    EXPECT_NEAR(g.x, slope, 1e-15);
    EXPECT_NEAR(g.y, 0, 1e-15);
  }
  // The blocker's vertices are 1 to 4, ends of its edge 5 and 6 from its left.
  const VertexDerivatives found = Oracle(scene).VertexDerivatives(kOriginUp);
  double sum = 0;
  for (const int number : {5, 6})
    sum += SlopeOf(found, number, 0).left;
  EXPECT_NEAR(sum, 2 * LineSlope(2, 0.5, -1, 1), 1e-15);
}

// Half of a lamp's edge is hidden: what its ends move is shared out over the
// whole edge.
TEST(Pitfalls, SharesAreOfTheWholeEdge) {
  const Scene scene = MakeScene(
      {{Ceiling(-2, 1, 0, 1, 2), kUnit}, {Ceiling(-3, 4, 0.25, 5, 1), kBlack}});
  const VertexDerivatives found = Oracle(scene).VertexDerivatives(kOriginUp);
  const double far_share = LineMoment(2, 1, 0, 0.5);
  ASSERT_TRUE(SlopeOf(found, 4, 0).IsSmooth());
  EXPECT_NEAR(SlopeOf(found, 4, 0).left, LineSlope(2, 1, 0, 0.5) - far_share,
              1e-16);
  EXPECT_NEAR(SlopeOf(found, 3, 0).left, far_share, 1e-16);
}

// Two blockers at different heights have edges in one plane through r, one
// beside the other: E is smooth, and each part of the plane has its distance.
TEST(Pitfalls, ArcsOfOnePlaneKeepTheirLines) {
  const Scene scene = MakeScene({{Ceiling(-2, 2, -1, 1, 2), kUnit},
                                 {Ceiling(0, 3, -4, -0.125, 1), kBlack},
                                 {Ceiling(0, 3, 0.1875, 4, 1.5), kBlack}});
  EXPECT_EQ(Oracle(scene).Derivatives(kOriginUp).smoothness, Smoothness::kC1);
  const double slope = LineSlope(2, -2, -1, 1) - LineSlope(2, 2, -0.25, 0.25) -
                       LineSlope(2, 0, -1, -0.25) * 2 -
                       LineSlope(2, 0, 0.25, 1) * 4 / 3;
  for (const Vector3& g : GradientsOf(scene, kOriginUp))
    EXPECT_NEAR(g.x, slope, 1e-15);
}

// A near lamp ends where a far one begins, both emit the same: E is that of one
// surface, but beside r there is a gap, or an overlap.
TEST(Pitfalls, LampsThatMeetInViewDoNotCancel) {
  const Scene scene = MakeScene(
      {{Ceiling(-1, 0, -2, 2, 1), kUnit}, {Ceiling(0, 2, -1, 1, 2), kUnit}});
  const Derivatives d = Oracle(scene).Derivatives(kOriginUp);
  ASSERT_EQ(d.smoothness, Smoothness::kKink);
  const double ends = LineSlope(1, -1, -2, 2) - LineSlope(2, 2, -1, 1);
  const double near = LineSlope(1, 0, -2, 2);
  const double far = LineSlope(2, 0, -1, 1);
  EXPECT_NEAR(OneSided(d, kRight), ends - near + far, 1e-15);
  EXPECT_NEAR(OneSided(d, kLeft), -ends + near - 2 * far, 1e-15);
}

// A blocker's edge covers the lamp's: which of the two bounds what is seen is
// arbitrary, and must not matter.
TEST(Pitfalls, OwnerOfCoincidentEdgesIsNotAsked) {
  const TestFace lamp = {Ceiling(0, 2, -1, 1, 2), kUnit};
  const TestFace blocker = {Ceiling(0, 0.5, -1, 1, 1), kBlack};
  const double right = 2 * LineSlope(2, 1, -1, 1) - LineSlope(2, 2, -1, 1);
  for (const Scene& scene :
       {MakeScene({lamp, blocker}), MakeScene({blocker, lamp})}) {
    const Derivatives d = Oracle(scene).Derivatives(kOriginUp);
    ASSERT_EQ(d.smoothness, Smoothness::kKink);
    EXPECT_NEAR(OneSided(d, kRight), right, 1e-15);
    EXPECT_NEAR(OneSided(d, kLeft), LineSlope(2, 0, -1, 1) - right, 1e-15);
  }
}

// Two lamps side by side are one for E. Each has its own vertices there: one
// that is pulled away opens a gap, one that is pushed covers what shines anyway.
TEST(Pitfalls, InnerEdgesCountForVerticesOfTheirOwn) {
  NumberedScene lamps;
  lamps.Add(Ceiling(-1, 0.5, -1, 1, 2), kUnit, {1, 2, 3, 4});
  lamps.Add(Ceiling(0.5, 1, -1, 1, 2), kUnit, {5, 6, 7, 8});
  const VertexDerivatives found =
      Oracle(lamps.Build()).VertexDerivatives(kOriginUp);
  const double half = LineSlope(2, 0.5, -1, 1) / 2;
  for (const int number : {3, 4}) {
    EXPECT_NEAR(SlopeOf(found, number, 0).left, half, 1e-16);
    EXPECT_EQ(SlopeOf(found, number, 0).right, 0);
  }
  for (const int number : {5, 6}) {
    EXPECT_EQ(SlopeOf(found, number, 0).left, 0);
    EXPECT_NEAR(SlopeOf(found, number, 0).right, -half, 1e-16);
  }
}

// In a room whose walls all shine alike, V = M n and nothing else; beside a wall
// the arc of its horizon is nearly pi.
TEST(Pitfalls, HorizonArcsOfNearlyPi) {
  std::vector<TestFace> walls;
  for (const Ring& ring : BoxAround(1))
    walls.push_back({ring, kUnit});
  const Scene scene = MakeScene(walls);
  for (const double gap : {0.75, 0x1p-20, 0x1p-50}) {
    const Receiver receiver{{1 - gap, 0.25, 0.125}, {0, 0, 1}, 0};
    const Derivatives d = Oracle(scene).Derivatives(receiver);
    EXPECT_EQ(d.undecided, 0);
    const ChannelDerivatives& c = d.channels[0];
    EXPECT_EQ(c.vector, (Vector3{0, 0, 1}));
    EXPECT_EQ(c.sphere, Vector3{});
    EXPECT_EQ(c.jacobian, Matrix3{});
    EXPECT_EQ(c.sphere_jacobian, Matrix3{});
    EXPECT_EQ(c.normal, Vector3{});
    const ChannelDerivatives plain = Oracle(scene, {.method = Method::kDouble})
                                         .Derivatives(receiver)
                                         .channels[0];
    EXPECT_NEAR(plain.vector.x, 0, 1e-14);
    EXPECT_NEAR(plain.vector.z, 1, 1e-14);
  }
}

// Two blockers close a slit: E is 0, and rises to one side.
TEST(Pitfalls, DarknessHasSlopes) {
  const Scene slit = MakeScene({{Ceiling(-1, 1, -1, 1, 2), kUnit},
                                {Ceiling(-3, 0, -4, 4, 1), kBlack},
                                {Ceiling(0, 3, -4, 4, 0.5), kBlack}});
  const Derivatives closed = Oracle(slit).Derivatives(kOriginUp);
  EXPECT_EQ(closed.irradiance.value, Rgb{});
  ASSERT_EQ(closed.kinks.size(), 1U);
  EXPECT_EQ(OneSided(closed, kRight), 0);
  EXPECT_NEAR(OneSided(closed, kLeft), 2 * LineSlope(2, 0, -1, 1), 1e-15);
  // In the plane of a lamp: x / (pi (x^2 + y^2)^2) summed over it.
  const Scene level = MakeScene({{Ceiling(1, 2, -1, 1, 0), kUnit}});
  const Derivatives dark = Oracle(level).Derivatives({{0, 0, 0}, {1, 0, 0}, 0});
  EXPECT_EQ(dark.irradiance.value, Rgb{});
  EXPECT_EQ(OneSided(dark, kUp), 0);
  EXPECT_NEAR(OneSided(dark, kDown),
              0.25 - std::atan(0.5) / (2 * std::numbers::pi), 1e-16);
}

// The receiver is below its own floor by rounding: the floor is away for the
// receivers and the vertices beside it, too.
TEST(Pitfalls, OnFaceHoldsBesideTheReceiver) {
  std::vector<TestFace> faces = {{Ceiling(0, 2, -1, 1, 2), kUnit},
                                 {Ceiling(0, 0.5, -1, 1, 1), kBlack}};
  const Oracle without(MakeScene(faces));
  faces.push_back({Floor(-1, 1, -1, 1, 0x1p-60), kBlack});
  const Oracle with(MakeScene(faces));
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 3};
  const Derivatives a = without.Derivatives(kOriginUp);
  const Derivatives b = with.Derivatives(receiver);
  ASSERT_EQ(a.kinks.size(), 1U);
  ASSERT_EQ(b.kinks.size(), 1U);
  EXPECT_EQ(a.kinks[0].size, b.kinks[0].size);
  EXPECT_EQ(a.channels[0].gradient, b.channels[0].gradient);
  EXPECT_EQ(a.channels[0].jacobian, b.channels[0].jacobian);
  const VertexDerivatives v = without.VertexDerivatives(kOriginUp);
  const VertexDerivatives w = with.VertexDerivatives(receiver);
  int one_sided = 0;
  for (int number = 1; number <= 8; ++number) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const VertexSlope& slope = SlopeOf(v, number, axis);
      EXPECT_EQ(slope.left, SlopeOf(w, number, axis).left);
      EXPECT_EQ(slope.right, SlopeOf(w, number, axis).right);
      one_sided += slope.IsSmooth() ? 0 : 1;
    }
  }
  EXPECT_GT(one_sided, 0);
}

// L instead of M: pi times as much, in every stage and of every kind. A double
// times pi is within an ulp.
TEST(Pitfalls, RadianceIsPiTimesAll) {
  constexpr double kPi = std::numbers::pi;
  const auto expect_pi_times = [](double radiance, double exitance) {
    EXPECT_NEAR(radiance, kPi * exitance, 4e-16 * std::fabs(radiance) + 1e-300);
  };
  for (const double x : {0.0, 0.25}) {  // at 0 the blocker covers an edge
    std::vector<TestFace> faces = Penumbra(x);
    faces.push_back({Ceiling(0, 0.75, 2, 3, 2), kUnit});
    const Scene scene = MakeScene(faces);
    for (const Method method : {Method::kCertified, Method::kDouble}) {
      const Derivatives m =
          Oracle(scene, {.method = method}).Derivatives(kOriginUp);
      const Derivatives l =
          Oracle(scene, {.method = method, .emission = Emission::kRadiance})
              .Derivatives(kOriginUp);
      const ChannelDerivatives& a = l.channels[0];
      const ChannelDerivatives& b = m.channels[0];
      EXPECT_NE(b.gradient.x, 0);
      const double slack = method == Method::kDouble ? 1e-14 : 1e-15;
      EXPECT_NEAR(a.gradient.x, kPi * b.gradient.x, slack);
      EXPECT_NEAR(a.gradient.z, kPi * b.gradient.z, slack);
      EXPECT_NEAR(a.vector.x, kPi * b.vector.x, slack);
      EXPECT_NEAR(a.normal.y, kPi * b.normal.y, slack);
      EXPECT_NEAR(a.flux, kPi * b.flux, slack);
      EXPECT_NEAR(a.sphere_jacobian[2][0], kPi * b.sphere_jacobian[2][0],
                  slack);
      ASSERT_EQ(l.kinks.size(), m.kinks.size());
      for (std::size_t i = 0; i < m.kinks.size(); ++i)
        expect_pi_times(l.kinks[i].size[0], m.kinks[i].size[0]);
      EXPECT_EQ(m.kinks.empty(), x != 0);
    }
    const VertexDerivatives m = Oracle(scene).VertexDerivatives(kOriginUp);
    const VertexDerivatives l = Oracle(scene, {.emission = Emission::kRadiance})
                                    .VertexDerivatives(kOriginUp);
    ASSERT_EQ(l.vertices.size(), m.vertices.size());
    for (std::size_t i = 0; i < m.vertices.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const VertexSlope& a = l.vertices[i].slopes[0][axis];
        const VertexSlope& b = m.vertices[i].slopes[0][axis];
        expect_pi_times(a.left, b.left);
        expect_pi_times(a.right, b.right);
      }
    }
  }
}

}  // namespace
}  // namespace truelux
