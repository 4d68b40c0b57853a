// SPDX-License-Identifier: GPL-3.0-or-later
// The sum over angular spans: the printed equation (9), and every bit of the
// sums over contours.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/stages/span_sum.h"
#include "scene/scene_access.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

using Faces = std::vector<TestFace>;

constexpr OracleOptions kSpans{.engine = Engine::kAngularSpans};
constexpr OracleOptions kTwin{.engine = Engine::kArrangement};
constexpr Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

/// The value from all engines.
Rgb All(const Faces& faces, const Receiver& r = kUp) {
  const Scene scene = MakeScene(faces);
  const Rgb value = Evaluate(scene, r, kSpans);
  EXPECT_EQ(value, Evaluate(scene, r));
  EXPECT_EQ(value, Evaluate(scene, r, kTwin));
  return value;
}

// ---- The paper's sum, as printed, in double -------------------------------

/// F of Stark & Riesenfeld 2000 (7), (8).
double PrintedF(double x, double y, double m) {
  const double a = 1 / std::sqrt(1 + x * x);
  const double c = 1 / std::sqrt(1 + m * m + (y - m * x) * (y - m * x));
  return a * x / 2 * std::atan(a * y) +
         c * (y - m * x) / 2 * std::atan(c * (x + m * y));
}

/// The sum (9) of one vertex on the image plane z = 1, which here is seen from
/// above; terms with undefined slope are omitted. In units of pi E.
Rgb PrintedSum(const Scene& scene, const SpanVertex& vertex) {
  const auto emission = [&](const AngularSpan& span) -> Rgb {
    if (!span.is_source) return {};
    return FacesOf(scene)[FaceOf(scene, span.facet)].emission;
  };
  const auto x_of = [](const Vec3<Exact>& d) {
    return d.x.to_double() / d.z.to_double();
  };
  const auto y_of = [](const Vec3<Exact>& d) {
    return d.y.to_double() / d.z.to_double();
  };
  const double x = x_of(vertex.direction);
  const double y = y_of(vertex.direction);
  Rgb sum{};
  Rgb previous = emission(vertex.spans.back());
  for (const AngularSpan& s : vertex.spans) {
    const Rgb m = emission(s);
    // The plane holds the z-axis, and its trace no slope, if N_y = 0.
    if (!s.edge_plane.y.is_zero()) {
      const double slope =
          -s.edge_plane.x.to_double() / s.edge_plane.y.to_double();
      const double f = PrintedF(x, y, slope);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += (m[c] - previous[c]) * f;
    }
    previous = m;
  }
  return sum;
}

TEST(AngularSpanSum, IsThePrintedEquationNine) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    PortableRandom random(seed);
    Faces faces = {{Ceiling(-8, 8, -8, 8, 16), kLamp}};
    for (int i = 0; i < 8; ++i) {
      Ring ring;
      for (int k = 0; k < 3; ++k) {
        ring.push_back({static_cast<double>(random.Integer(-4, 4)),
                        static_cast<double>(random.Integer(-4, 4)),
                        static_cast<double>(random.Integer(4, 8))});
      }
      if (OnOneLine(ring[0], ring[1], ring[2])) continue;
      faces.push_back({ring, random.OneIn(2) ? Rgb{0.25, 3, 0} : kBlack});
    }
    const Scene scene = MakeScene(faces);
    Rgb sum{};
    for (const SpanVertex& v : AngularSpansOf({scene, kUp}).vertices) {
      const Rgb term = PrintedSum(scene, v);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += term[c] / std::numbers::pi;
    }
    const Rgb value = Evaluate(scene, kUp, kSpans);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(sum[c], value[c], 1e-13);
  }
}

// ---- Vertices contribute independently ------------------------------------

TEST(AngularSpanSum, HasNoOrderOfVerticesAndNoFirstSpan) {
  PortableRandom random(5);
  for (int i = 0; i < 20; ++i) {
    const Scene scene = MakeScene(RandomScene(random, true, 8, 3));
    const ContourQuery query{scene, RandomReceiver(random, true, 3)};
    AngularSpans spans = AngularSpansOf(query);
    const Rgb value = EvaluateSpans(query, spans, {}).value;
    EXPECT_EQ(value, Evaluate(scene, query.receiver));
    std::ranges::reverse(spans.vertices);
    for (SpanVertex& v : spans.vertices) {
      std::rotate(v.spans.begin(),
                  v.spans.begin() +
                      random.Integer(0, static_cast<int>(v.spans.size()) - 1),
                  v.spans.end());
    }
    EXPECT_EQ(EvaluateSpans(query, spans, {}).value, value);
  }
}

/// Whether one edge only passes, its slope the same before and after.
bool IsStraight(const SpanVertex& v) {
  if (v.spans.size() != 2) return false;
  const Vec3<Exact> c = Cross(v.spans[0].edge_plane, v.spans[1].edge_plane);
  return c.x.is_zero() && c.y.is_zero() && c.z.is_zero();
}

TEST(AngularSpanSum, NeedsEveryVertexButTheExtraneous) {
  // No corner is on a diagonal, where its two edges would cancel.
  const Faces faces = {{Ceiling(1, 8, 2, 9, 16), kLamp},
                       {Ceiling(1, 2, 0.75, 1.75, 4)}};
  const ContourQuery query{MakeScene(faces), kUp};
  const AngularSpans spans = AngularSpansOf(query);
  const Rgb value = EvaluateSpans(query, spans, {}).value;
  int extraneous = 0;
  for (std::size_t i = 0; i < spans.vertices.size(); ++i) {
    AngularSpans fewer = spans;
    fewer.vertices.erase(fewer.vertices.begin() +
                         static_cast<std::ptrdiff_t>(i));
    const bool is_straight = IsStraight(spans.vertices[i]);
    EXPECT_EQ(EvaluateSpans(query, fewer, {}).value == value, is_straight);
    if (is_straight) ++extraneous;
  }
  // Where the source's diagonal meets two edges of the blocker.
  EXPECT_EQ(extraneous, 2);
  EXPECT_EQ(spans.vertices.size(), 4U + 4 + 2);
}

// ---- The same bits as the other engines -----------------------------------

/// Every way to ask, against the contour engine; returns the irradiance.
Irradiance ExpectTheSameBits(const Faces& faces, const Receiver& r) {
  const Scene scene = MakeScene(faces);
  const Oracle spans(scene, kSpans);
  const Oracle contour(scene);
  const Irradiance e = spans.Evaluate(r);
  const Irradiance expected = contour.Evaluate(r);
  EXPECT_EQ(e.value, expected.value);
  EXPECT_EQ(e.bound, expected.bound);
  EXPECT_EQ(e.statistics.evaluated_zero, expected.statistics.evaluated_zero);
  for (const Emission emission : {Emission::kExitance, Emission::kRadiance}) {
    OracleOptions options{.emission = emission};
    const Irradiance by_contour = Oracle(scene, options).Evaluate(r);
    options.engine = Engine::kAngularSpans;
    EXPECT_EQ(Oracle(scene, options).Evaluate(r).value, by_contour.value);
    options.method = Method::kDouble;
    const Irradiance plain = Oracle(scene, options).Evaluate(r);
    EXPECT_EQ(plain.value, by_contour.value);
    EXPECT_EQ(plain.bound, by_contour.bound);
  }
  for (int face = 1; face <= static_cast<int>(faces.size()); ++face) {
    EXPECT_EQ(spans.FormFactor(r, face).value,
              contour.FormFactor(r, face).value);
  }
  return e;
}

class SpanSoups : public ::testing::TestWithParam<bool> {};

TEST_P(SpanSoups, EveryBitIsThatOfTheContourEngine) {
  int lit = 0;
  int dark = 0;
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    PortableRandom random(seed);
    const int range = random.Integer(1, 3);
    const Faces faces =
        RandomScene(random, GetParam(), random.Integer(2, 9), range);
    const Irradiance e =
        ExpectTheSameBits(faces, RandomReceiver(random, GetParam(), range));
    ++(e.value[0] > 0 ? lit : dark);
  }
  EXPECT_GT(lit, 5);
  EXPECT_GT(dark, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpanSoups, ::testing::Bool(),
                         [](const auto& instance) {
                           return instance.param ? "Lattice" : "General";
                         });

TEST(AngularSpanSum, OfTwelveEdgesAndACornerThroughOnePoint) {
  // By angle. The nearer ones come first, so that some is seen of each.
  constexpr int kSteps[12][2] = {{1, 0},  {3, 1},  {2, 1},  {1, 1},
                                 {1, 2},  {1, 3},  {0, 1},  {-1, 3},
                                 {-1, 2}, {-1, 1}, {-2, 1}, {-3, 1}};
  Faces faces = {
      {Ceiling(-8, 8, -8, 8, 16), kLamp},
      {Scaled({{2, 1, 16}, {1.75, 1.25, 16}, {2.25, 1.25, 16}}, 0x1p-14)}};
  for (int i = 0; i < 12; ++i) {
    const double dx = kSteps[i][0] / 8.0;
    const double dy = kSteps[i][1] / 8.0;
    const Ring left_of_line = {
        {2 + dx, 1 + dy, 16}, {2 - dx, 1 - dy, 16}, {2 - dy, 1 + dx, 16}};
    faces.push_back({Scaled(left_of_line, std::ldexp(1, i - 13)),
                     i % 3 == 0 ? Rgb{2, 0.5, 7} : kBlack});
  }
  const AngularSpans spans = AngularSpansOf({MakeScene(faces), kUp});
  const auto most = std::ranges::max_element(
      spans.vertices, {}, [](const SpanVertex& v) { return v.spans.size(); });
  // The lamp, 12 half-planes, the corner, and the nearest in two pieces.
  EXPECT_EQ(most->spans.size(), 15U);
  const Rgb value = All(faces);
  EXPECT_GT(value[0], 0);
  std::ranges::reverse(faces);
  EXPECT_EQ(All(faces), value);
}

TEST(AngularSpanSum, WeightsEachChannelWithItsOwnEmissions) {
  // Two emitters that overlap, one lit in each channel; alone, the other is
  // black and hides what it hides.
  const Ring near = Ceiling(-1, 3, -1, 1, 4);
  const Ring far = Ceiling(-5, 6, -3, 7, 8);
  const Rgb both = All({{far, {3, 0, 1}}, {near, {0, 5, 1}}});
  EXPECT_EQ(both[0], All({{far, {3, 0, 0}}, {near}})[0]);
  EXPECT_EQ(both[1], All({{far}, {near, {0, 5, 0}}})[1]);
  const double both_lit =
      All({{far, {0, 0, 1}}, {near}})[2] + All({{far}, {near, {0, 0, 1}}})[2];
  EXPECT_NEAR(both[2], both_lit, 1e-15);
  // Equal emission leaves nothing to add where one is before the other.
  EXPECT_EQ(All({{far, kLamp}, {Scaled(near, 0.5), kLamp}}),
            All({{far, kLamp}}));
}

TEST(AngularSpanSum, OfTheHorizon) {
  // A closed box of one emission gives that emission, wherever the receiver.
  Faces box;
  for (const Ring& ring : BoxAround(1))
    box.push_back({ring, kLamp});
  EXPECT_EQ(All(box), kLamp);
  EXPECT_EQ(All(box, {{0.25, -0.5, 0.125}, {1, 2, -1}, 0}), kLamp);
  // Octants, whose edges lie in the receiver plane and in planes through n.
  const Ring octant = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(All({{octant, {1, 2, 4}}}), (Rgb{0.25, 0.5, 1}));
  // Walls that stand on it, go below it, or end in a corner on it.
  const Ring wall = {{2, -1, 0}, {2, -1, 3}, {2, 1, 3}, {2, 1, 0}};
  const Ring deep = {{2, -1, -3}, {2, -1, 3}, {2, 1, 3}, {2, 1, -3}};
  const Ring drop = {{2, -1, 1}, {2, 0, 2}, {2, 1, 1}, {2, 0, 0}};
  EXPECT_EQ(All({{wall, kLamp}}), All({{deep, kLamp}}));
  EXPECT_LT(All({{wall, kLamp}, {Scaled(drop, 0.5)}})[0],
            All({{wall, kLamp}})[0]);
  EXPECT_EQ(All({{wall, kLamp}, {Scaled(deep, 0.5)}}), kBlack);
  // Two walls of different emission that share an edge that stands on it.
  const Ring side = {{2, 1, 0}, {2, 1, 3}, {-1, 1, 3}, {-1, 1, 0}};
  EXPECT_GT(All({{wall, kLamp}, {side, {7, 0, 1}}})[1], 0);
}

TEST(AngularSpanSum, OfEmissionsAtTheEndsOfTheRange) {
  constexpr double kMost = std::numeric_limits<double>::max();
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const Ring octant = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  const Ring other = {{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
  const Faces faces = {{octant, {kMost, kMost, 5 * kLeast}},
                       {other, {kMost, 0x1p900, kLeast}}};
  const Rgb value = All(faces);
  EXPECT_EQ(value[0], kMost / 2);
  EXPECT_EQ(value[2], 2 * kLeast);  // 1.5, a tie
  const Irradiance e = ExpectTheSameBits(faces, kUp);
  EXPECT_EQ(e.statistics.ties, 1U);
  EXPECT_EQ(e.statistics.evaluated_multiprecision, 1U);
}

TEST(AngularSpanSum, IsZeroWhereNothingIsSeen) {
  const Irradiance e = Oracle(MakeScene({{Ceiling(-1, 1, -1, 1, 4), kLamp},
                                         {Ceiling(-1, 1, -1, 1, 2)}}),
                              kSpans)
                           .Evaluate(kUp);
  EXPECT_EQ(e.value, kBlack);
  EXPECT_EQ(e.bound, kBlack);
  EXPECT_EQ(e.statistics.evaluated_zero, 1U);
  EXPECT_EQ(e.statistics.sources, 1U);
}

TEST(AngularSpanSum, HasTheContourOfTheArrangement) {
  const Scene scene =
      MakeScene({{Ceiling(-1, 2, -3, 1, 4), kLamp}, {Ceiling(0, 1, -9, 0, 3)}});
  const VisibleContour a = Oracle(scene, kSpans).Contour(kUp);
  const VisibleContour b = Oracle(scene, kTwin).Contour(kUp);
  EXPECT_GE(a.arcs.size(), 6U);
  EXPECT_EQ(a.arcs.size(), b.arcs.size());
  EXPECT_EQ(a.vertices.size(), b.vertices.size());
}

}  // namespace
}  // namespace truelux
