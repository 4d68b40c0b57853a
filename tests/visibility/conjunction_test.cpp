// SPDX-License-Identifier: GPL-3.0-or-later
// Conjunctions of every kind: what coincides exactly as seen from r must give
// exactly the value of the simpler scene, and one ulp off a value close by.

#include <cmath>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

const Ring kSource = Ceiling(-8, 8, -8, 8, 16);

constexpr OracleOptions kTwin{.engine = Engine::kArrangement};
constexpr OracleOptions kSpans{.engine = Engine::kAngularSpans};

/// The certified value, from all engines.
Rgb All(const std::vector<TestFace>& faces) {
  const Scene scene = MakeScene(faces);
  const Receiver r{{0, 0, 0}, {0, 0, 1}, 0};
  const Rgb value = Evaluate(scene, r);
  EXPECT_EQ(Evaluate(scene, r, kTwin), value);
  EXPECT_EQ(Evaluate(scene, r, kSpans), value);
  return value;
}

/// A triangle whose one edge passes, as seen from the origin, through the
/// image point (2, 1) of z = 16, in the lattice direction (dx, dy), to its
/// left; moved to its own depth.
TestFace EdgeThroughPoint(int dx, int dy, double depth) {
  const Ring ring = {{2.0 + 3 * dx, 1.0 + 3 * dy, 16},
                     {2.0 - 3 * dx, 1.0 - 3 * dy, 16},
                     {2.0 - 2 * dy, 1.0 + 2 * dx, 16}};
  return {Scaled(ring, depth)};
}

class EdgesThroughOnePoint : public ::testing::TestWithParam<int> {};

TEST_P(EdgesThroughOnePoint, AnyOrderAndAnyDepthsGiveTheSameBits) {
  constexpr int kDirections[12][2] = {{1, 0}, {0, 1},  {1, 1}, {-1, 1},
                                      {2, 1}, {-1, 2}, {1, 2}, {-2, 1},
                                      {3, 1}, {-1, 3}, {1, 3}, {-3, 1}};
  const int k = GetParam();
  std::vector<TestFace> faces = {{kSource, kLamp}};
  std::vector<TestFace> reversed = {{kSource, kLamp}};
  for (int i = 0; i < k; ++i) {
    const int dx = kDirections[i][0];
    const int dy = kDirections[i][1];
    faces.push_back(EdgeThroughPoint(dx, dy, std::ldexp(1, -1 - i % 3)));
    reversed.insert(reversed.begin() + 1,
                    EdgeThroughPoint(dx, dy, std::ldexp(0.75, -(i + 1) % 4)));
  }
  const Rgb e = All(faces);
  EXPECT_EQ(All(reversed), e);
  EXPECT_LT(e[0], FromBelow({{kSource, kLamp}})[0]);

  // One ulp off: another scene, almost the same value.
  PortableRandom random(static_cast<std::uint64_t>(k));
  for (TestFace& face : faces) {
    for (Point3& p : face.ring)
      p.x = random.Nudge(p.x);
  }
  EXPECT_NEAR(All(faces)[0], e[0], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Edges, EdgesThroughOnePoint, ::testing::Range(3, 13));

TEST(Conjunction, VertexOnEdgeAndVerticesInLine) {
  const Ring first = {{0, 0, 8}, {4, 0, 8}, {0, 4, 8}};
  // A vertex on the image of the hypotenuse, inside of the first's shadow.
  const Ring on_edge = {{1, 1, 4}, {0.5, 0.25, 4}, {0.25, 0.5, 4}};
  // A vertex in line with the first's corner, inside as well.
  const Ring in_line = {{2, 0, 4}, {0.5, 0.25, 4}, {0.25, 0.5, 4}};
  const Rgb e = All({{kSource, kLamp}, {first}});
  EXPECT_EQ(All({{kSource, kLamp}, {first}, {on_edge}}), e);
  EXPECT_EQ(All({{kSource, kLamp}, {first}, {in_line}}), e);
  EXPECT_EQ(All({{in_line}, {on_edge}, {kSource, kLamp}, {first}}), e);
}

TEST(Conjunction, EdgesThroughAnIntrinsicVertexOfTheSource) {
  // The quadrant of the source beyond its own corner is nothing to hide.
  const Ring corner = {{2, 2, 4}, {4, 2, 4}, {4, 4, 4}, {2, 4, 4}};
  const Rgb e = All({{kSource, kLamp}});
  EXPECT_EQ(All({{kSource, kLamp}, {corner}}), e);
  // Edges that pass through the corner of the source and cut a piece off.
  const Ring half = {{2, 2, 4}, {-2, -2, 4}, {2, -4, 4}};
  const Ring other = {{4, 4, 8}, {-4, -4, 8}, {-8, 8, 8}};
  const Rgb upper = All({{{{-8, -8, 16}, {-8, 8, 16}, {8, 8, 16}}, kLamp}});
  EXPECT_EQ(All({{kSource, kLamp}, {half}}), upper);
  EXPECT_EQ(All({{kSource, kLamp}, {half}, {other}}), kBlack);
}

TEST(Conjunction, CollinearEdgesThatOverlap) {
  const Ring left = {{-4, -4, 8}, {0, -4, 8}, {0, 4, 8}, {-4, 4, 8}};
  const Ring right = {{0, -1, 4}, {4, -2, 4}, {4, 2, 4}, {0, 1.5, 4}};
  const Rgb first = All({{kSource, kLamp}, {left}, {right}});
  EXPECT_EQ(All({{right}, {kSource, kLamp}, {left}}), first);
  // Together with a filler they hide everything.
  const Ring filler = {{0, -2, 4}, {2, -2, 4}, {2, 2, 4}, {0, 2, 4}};
  EXPECT_EQ(All({{kSource, kLamp}, {left}, {right}, {filler}}), kBlack);
}

TEST(Conjunction, ScaledCopyHidesExactly) {
  const Ring odd = {{-3, -5, 16}, {1, 7, 16}, {5, 2, 16}, {0.5, -1, 16}};
  for (const double factor : {0.5, 0.25, 0.0625, 0x1p-20}) {
    EXPECT_EQ(All({{odd, kLamp}, {Scaled(odd, factor)}}), kBlack);
    EXPECT_EQ(All({{odd, kLamp}, {Reversed(Scaled(odd, factor))}}), kBlack);
  }
  EXPECT_EQ(All({{odd, kLamp}, {Scaled(odd, 2)}}), All({{odd, kLamp}}));
}

TEST(Conjunction, TilingOfTheConeAtAnyDepthsHidesExactly) {
  // 4 x 4 tiles of the source, each at its own depth; then one left out.
  std::vector<TestFace> faces = {{kSource, kLamp}};
  int n = 0;
  for (int i = -2; i < 2; ++i) {
    for (int j = -2; j < 2; ++j) {
      const Ring tile = Ceiling(4 * i, 4 * i + 4, 4 * j, 4 * j + 4, 16);
      faces.push_back({Scaled(tile, std::ldexp(1, -1 - (n++ * 7) % 5))});
    }
  }
  EXPECT_EQ(All(faces), kBlack);
  std::vector<TestFace> open = faces;
  open.erase(open.begin() + 6);
  const Ring tile6 = Ceiling(-4, 0, -4, 0, 16);
  EXPECT_EQ(All(open), All({{tile6, kLamp}}));
}

}  // namespace
}  // namespace truelux
