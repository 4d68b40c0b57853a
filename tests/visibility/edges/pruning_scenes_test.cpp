// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes made by hand, each for one step of the contour engine that leaves
// something out: the values are those of its slow twin, which does not.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/evaluate.h"
#include "support/plain_contour.h"
#include "support/portable_random.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Rgb kWhite{1, 1, 1};
constexpr Rgb kYellow{1, 1, 0.5};
const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

/// Tilted, so that arcs in planes through the vertical add something.
const Receiver kTilted{{0, 0, 0}, {1, 0, 2}, 0};

/// A lamp that is no convex piece.
const Ring kLShape{{-2, -2, 3}, {-2, 2, 3}, {0, 2, 3},
                   {0, 0, 3},   {2, 0, 3},  {2, -2, 3}};

/// Returns E, red.
double Compare(const std::vector<TestFace>& faces, const Receiver& receiver) {
  const Scene scene = MakeScene(faces);
  const ContourQuery query{scene, receiver};
  const Rgb expected = EvaluateContour(query, PlainContour(query), {}).value;
  EXPECT_EQ(Oracle(scene).Evaluate(receiver).value, expected);
  return expected[0];
}

TEST(PruningScenes, WallsThatHangOutsideTheEdgesOfAnLShapedLamp) {
  for (std::size_t k = 0; k < kLShape.size(); ++k) {
    const Point3& a = kLShape[k];
    const Point3& b = kLShape[(k + 1) % kLShape.size()];
    const Ring wall{a, b, {b.x, b.y, 2.5}, {a.x, a.y, 2.5}};
    EXPECT_GT(Compare({{kLShape, kWhite}, {wall, kBlack}},
                      {{-0.5, -0.25, 0}, {0, 0, 1}, 0}),
              0);
  }
}

TEST(PruningScenes, ABlockerThatHidesSomePiecesOfALampWhole) {
  int dark = 0;
  int lit = 0;
  for (int turn = 0; turn < 16; ++turn) {
    const double c = std::cos(turn * std::numbers::pi / 8);
    const double s = std::sin(turn * std::numbers::pi / 8);
    for (int step = -8; step <= 2; ++step) {
      const double shift = 0.25 * step;
      const auto at = [&](double u, double v) {
        return Point3{u * c - v * s, u * s + v * c, 1};
      };
      const double e =
          Compare({{kLShape, kWhite},
                   {{at(shift, -9), at(shift, 9), at(9, 0)}, kBlack}},
                  {{-0.01, -0.02, 0}, {0, 0, 1}, 0});
      ++(e > 0 ? lit : dark);
    }
  }
  EXPECT_GT(lit, 20);
  EXPECT_GT(dark, 2);
}

TEST(PruningScenes, OfManyEqualConesOneEachStays) {
  std::vector<TestFace> faces{{Ceiling(-4, 4, -4, 4, 4), kWhite}};
  for (int i = 0; i < 20; ++i) {
    const int row = i / 5;
    const double x = (i % 5 - 2) * 0.5;
    const double y = (row - 2) * 0.5;
    const Ring small{{x, y, 1}, {x + 0.25, y, 1}, {x, y + 0.25, 1}};
    faces.push_back({small, kBlack});
    faces.push_back({Scaled(small, 2), kBlack});
  }
  EXPECT_GT(Compare(faces, kUp), 0);
}

TEST(PruningScenes, TwoEdgesInOnePlaneOverAnLShapedLamp) {
  EXPECT_GT(Compare({{kLShape, kWhite},
                     {Ceiling(-1, -0.25, -0.5, 0.5, 1), kBlack},
                     {Ceiling(-1.5, -0.5, -0.5, 1.5, 2), kBlack}},
                    kTilted),
            0);
}

TEST(PruningScenes, ABlockerOnOneSideOfASharedEdge) {
  for (const Ring& blocker :
       {Ceiling(0, 0.25, -0.25, 0.25, 1), Ceiling(-0.25, 0, -1, 0.25, 1)}) {
    EXPECT_GT(Compare({{Ceiling(-1, 0, -1, 1, 2), kWhite},
                       {Ceiling(0, 1, -1, 1, 2), kWhite},
                       {blocker, kBlack}},
                      kTilted),
              0);
  }
}

TEST(PruningScenes, FourFacesOfTwoEmissionsOnOneEdge) {
  const Ring upright{{0, -1, 2}, {0, 1, 2}, {0, 1, 3}, {0, -1, 3}};
  const Ring leaning{{0, -1, 2}, {0, 1, 2}, {1, 1, 3}, {1, -1, 3}};
  for (const bool reversed : {false, true}) {
    EXPECT_GT(Compare({{Ceiling(-1, 0, -1, 1, 2), kWhite},
                       {Ceiling(0, 1, -1, 1, 2), kYellow},
                       {reversed ? Reversed(upright) : upright, kWhite},
                       {reversed ? Reversed(leaning) : leaning, kYellow}},
                      {{0.3, 0.1, 0}, {0, 0, 1}, 0}),
              0);
  }
}

TEST(PruningScenes, AFinWhoseInnerEdgeLiesInTheLampsPlane) {
  EXPECT_GT(
      Compare(
          {{Ceiling(-4, 4, -4, 4, 4), kWhite},
           {Ceiling(-1, 1, -1, 1, 2), kLamp},
           {{{0, -.5, 2}, {0, .5, 2}, {0, .5, 3}, {0, -.5, 3}}, kBlack},
           {{{0, -.5, 2}, {0, .5, 2}, {0, .5, 1.5}, {0, -.5, 1.5}}, kBlack}},
          {{0.3, 0.1, 0}, {0, 0, 1}, 0}),
      0);
}

TEST(PruningScenes, BlocksOfReceiversWithBlockersOfTheirOwn) {
  PortableRandom random(5);
  std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 8), kLamp}};
  for (int i = 0; i < 40; ++i) {
    const double x = i % 2 == 0 ? -10 : 10;
    const auto corner = [&]() -> Point3 {
      return {x + random.Uniform(-1, 1), random.Uniform(-1, 1),
              4 + random.Uniform(-1, 1)};
    };
    faces.push_back({{corner(), corner(), corner()}, kBlack});
  }
  const Oracle oracle(MakeScene(faces));
  // Sixteen on one side, sixteen on the other, and so on.
  std::vector<Receiver> receivers;
  for (int i = 0; i < 64; ++i) {
    const double side = i / 16 % 2 == 0 ? -20 : 20;
    receivers.push_back({{side + 0.01 * i, 0, 0}, {0, 0, 1}, 0});
  }
  const auto together = oracle.Evaluate(receivers);
  int partly_lit = 0;
  for (std::size_t k = 0; k < receivers.size(); ++k) {
    EXPECT_EQ(together[k].value, oracle.Evaluate(receivers[k]).value);
    if (together[k].value[0] > 0 && together[k].statistics.blockers > 0) {
      ++partly_lit;
    }
  }
  EXPECT_GT(partly_lit, 15);
}

/// How many triangles of a fine mesh block matters to the time, but its inner
/// edges must not: none of them is an edge of the contour, or in its way.
TEST(PruningScenes, InnerEdgesOfABlockingMeshAreNotSwept) {
  const auto sides = [](int n) {
    std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp}};
    const double step = 1.0 / n;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        faces.push_back(
            {Ceiling(i * step, (i + 1) * step, k * step, (k + 1) * step, 2),
             kBlack});
      }
    }
    return Oracle(MakeScene(faces))
        .Evaluate({{0.3, 0.1, 0}, {0, 0, 1}, 0})
        .statistics.plane_side.filter;
  };
  // 16 times as many quads, with a border 4 times as long.
  EXPECT_LT(sides(32), 8 * sides(8));
}

}  // namespace
}  // namespace truelux
