// SPDX-License-Identifier: GPL-3.0-or-later
// Kinks by the arrangement engine, which shares no line of visibility with the
// contour engine: its gradients on both sides of a receiver on a lattice, at a
// distance that binary64 can say if the receiver is the origin, but no
// predicate that is not zero there can feel. Mean and jump have the same bits.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/arrangement_lines.h"
#include "radiometry/derivatives/kink_planes.h"
#include "radiometry/derivatives/limits.h"
#include "radiometry/evaluate.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

using ChannelGradients = std::array<Vec3<ArbReal>, 3>;

/// The gradients at a receiver by the arcs that the arrangement engine sees.
ChannelGradients GradientsOf(const ContourQuery& query, slong precision) {
  const Contour contour = ArrangementLines(query.scene).Find(query);
  std::vector<Rgb> weights;
  FindWeights(query, contour, weights);
  const auto fields = ArbFieldsOf(MovingContourOf(ViewOf(query), contour),
                                  weights.size(), precision);
  const Vec3<ArbReal> n = ArbVector(
      precision, RecipeEvaluator<Exact>(ViewOf(query)).ReceiverNormal());
  ChannelGradients gradients;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Field<ArbReal> sum = NoField(precision);
    for (std::size_t s = 0; s < fields.size(); ++s)
      AddTimes(fields[s], ArbReal(precision, Exact(weights[s][channel])), sum);
    const auto components = ComponentsOf(sum, sum, n, n);
    gradients[channel] = {components[kGradientAt], components[kGradientAt + 1],
                          components[kGradientAt + 2]};
  }
  return gradients;
}

/// The nearest binary64 to a limit of numbers of about 1, which the step leaves
/// uncertain by less than 2^-400.
double Rounded(const ArbReal& x) {
  return x.IsAtMost(ArbReal(64, 1L).TimesTwoTo(-400)) ? 0 : x.Nearest();
}

Vector3 Rounded(const Vec3<ArbReal>& v) {
  return {Rounded(v.x), Rounded(v.y), Rounded(v.z)};
}

/// Receivers with candidates for kinks.
struct Counts {
  int smooth = 0;   ///< lit, with none all the same
  int kinks = 0;    ///< with one
  int several = 0;  ///< with more
};

/// query: its receiver is at the origin. d: in general position.
void CompareLimits(const Oracle& oracle, ContourQuery query, const Vector3& d,
                   Counts& counts) {
  const Derivatives expected = oracle.Derivatives(query.receiver);
  const CoordinateRange range = CoordinateRangeOf(query);
  const long exponent = range.StepExponent();
  ASSERT_GT(exponent, -900);
  const double step = std::ldexp(1.0, static_cast<int>(exponent));
  const slong precision = StepPrecision(exponent);
  query.receiver.position = {step * d.x, step * d.y, step * d.z};
  const ChannelGradients after = GradientsOf(query, precision);
  query.receiver.position = {-step * d.x, -step * d.y, -step * d.z};
  const ChannelGradients before = GradientsOf(query, precision);
  const ArbReal half = ArbReal(precision, 1L).TimesTwoTo(-1);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(Rounded(half * (after[channel] + before[channel])),
              expected.channels[channel].gradient);
    const Vec3<ArbReal> jump = half * (after[channel] - before[channel]);
    if (expected.kinks.empty()) {
      EXPECT_EQ(Rounded(jump), Vector3{});
    } else if (expected.kinks.size() == 1) {
      EXPECT_EQ(Rounded(Sqrt(Dot(jump, jump))),
                std::fabs(expected.kinks[0].size[channel]));
    }
  }
  if (expected.kinks.empty() && expected.irradiance.value != Rgb{})
    ++counts.smooth;
  if (expected.kinks.size() == 1) ++counts.kinks;
  if (expected.kinks.size() > 1) ++counts.several;
}

TEST(ArrangementLimits, MeanAndJumpHaveTheSameBits) {
  Counts counts;
  for (int seed = 0; seed < SweepSize(200, 1000); ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) + 4200);
    std::vector<TestFace> faces =
        RandomScene(random, true, random.Integer(3, 12), 3);
    Receiver receiver = RandomReceiver(random, true, 3);
    const Point3 r = receiver.position;
    for (TestFace& face : faces) {
      for (Point3& p : face.ring)
        p = {p.x - r.x, p.y - r.y, p.z - r.z};
    }
    receiver.position = {};
    const Scene scene = MakeScene(faces);
    const ContourEngine engine(scene);
    const ContourQuery query{scene, receiver};
    SeenLineFinder finder(engine);
    const KinkCandidates candidates =
        FindKinkPlanes(engine, query, finder.Find(query));
    // On a face there are no two sides.
    if (candidates.planes.empty() || candidates.touched.valid()) continue;
    const Vector3 d = {0.5 + random.Unit(), -0.25 - random.Unit(),
                       random.Uniform(-1, 1)};
    CompareLimits(Oracle(scene), query, d, counts);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(counts.smooth, 10);
  EXPECT_GT(counts.kinks, 10);
  RecordProperty("smooth", counts.smooth);
  RecordProperty("kinks", counts.kinks);
  RecordProperty("several", counts.several);
}

}  // namespace
}  // namespace truelux
