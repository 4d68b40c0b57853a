// SPDX-License-Identifier: GPL-3.0-or-later
// Each condition of docs/method.md, section 4, in a scene that goes wrong when
// the condition is loosened. Expected values are those of simpler scenes.

#include <cmath>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

const Ring kSource = Ceiling(-2, 2, -2, 2, 4);

Rgb Sum(const Rgb& a, const Rgb& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

void ExpectNear(const Rgb& a, const Rgb& b) {
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_DOUBLE_EQ(a[c], b[c]);
}

TEST(Source, IsBlackFromBehind) {
  EXPECT_EQ(FromBelow({{Reversed(kSource), kLamp}}), kBlack);
}

constexpr Rgb kBlue{0, 0, 1};

TEST(Source, InsideIsInsideOneOfItsTriangles) {
  // An L: its diagonal must not cut it, its notch must not emit.
  const Ring l = {{-2, -2, 4}, {-2, 2, 4}, {0, 2, 4},
                  {0, 0, 4},   {2, 0, 4},  {2, -2, 4}};
  const Rgb whole = FromBelow({{l, kLamp}});
  ExpectNear(whole, Sum(FromBelow({{Ceiling(-2, 0, -2, 2, 4), kLamp}}),
                        FromBelow({{Ceiling(0, 2, -2, 0, 4), kLamp}})));
  // What emits in blue only, and comes first, takes the notch out in red.
  EXPECT_EQ(whole[0],
            FromBelow({{Ceiling(0, 2, 0, 2, 4), kBlue}, {kSource, kLamp}})[0]);
}

TEST(Source, DiagonalInTheReceiverPlaneStays) {
  // The quad's diagonal lies in the receiver plane; only one half is above.
  const Ring quad = {{3, -2, 0}, {3, 0, -2}, {3, 2, 0}, {3, 0, 2}};
  const Ring upper = {{3, -2, 0}, {3, 2, 0}, {3, 0, 2}};
  const Rgb half = FromBelow({{Reversed(upper), kLamp}});
  EXPECT_GT(half[0], 0);
  EXPECT_EQ(FromBelow({{Reversed(quad), kLamp}}), half);
  // The other diagonal, and both starting points of the ring.
  const Ring turned = {{3, 0, -2}, {3, 2, 0}, {3, 0, 2}, {3, -2, 0}};
  EXPECT_EQ(FromBelow({{Reversed(turned), kLamp}}), half);
}

TEST(Source, DiagonalThatCrossesTheHorizonIsNoEdge) {
  const Ring quad = {{4, -3, -1}, {4, 3, -2}, {4, 3, 5}, {4, -3, 3}};
  const Ring start2 = {{4, 3, -2}, {4, 3, 5}, {4, -3, 3}, {4, -3, -1}};
  const Rgb e = FromBelow({{Reversed(quad), kLamp}});
  EXPECT_GT(e[0], 0);
  EXPECT_EQ(FromBelow({{Reversed(start2), kLamp}}), e);
}

TEST(Blocker, HidesFromEitherSideAndAlsoWhenBlack) {
  const Ring half = Ceiling(-1, 0, -1, 1, 2);
  const Rgb expected = FromBelow({{Ceiling(0, 2, -2, 2, 4), kLamp}});
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {half}}), expected);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {Reversed(half)}}), expected);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {Reversed(half), kLamp}}), expected);
}

TEST(Blocker, BehindTheSourceHidesNothing) {
  const Rgb alone = FromBelow({{kSource, kLamp}});
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {Ceiling(-9, 9, -9, 9, 5)}}), alone);
  EXPECT_EQ(FromBelow({{Ceiling(-9, 9, -9, 9, 5)}, {kSource, kLamp}}), alone);
}

TEST(Blocker, TouchingTheSourcesPlaneFromBehindHidesNothing) {
  const Rgb alone = FromBelow({{kSource, kLamp}});
  const Ring fin = {{-1, 0, 4}, {1, 1, 4}, {0, 1, 6}};
  EXPECT_EQ(FromBelow({{fin}, {kSource, kLamp}}), alone);
}

TEST(Blocker, CoplanarHidesOnlyIfItEmitsAndIsEarlierInTheFile) {
  const Ring patch = Ceiling(0, 2, -2, 2, 4);
  const Rgb alone = FromBelow({{kSource, kLamp}});
  const Rgb left = FromBelow({{Ceiling(-2, 0, -2, 2, 4), kLamp}});
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {patch}}), alone);
  EXPECT_EQ(FromBelow({{patch}, {kSource, kLamp}}), alone);
  EXPECT_EQ(FromBelow({{Reversed(patch), kLamp}, {kSource, kLamp}}), alone);
  EXPECT_EQ(FromBelow({{patch, kBlue}, {kSource, kLamp}})[0], left[0]);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {patch, kBlue}})[0], alone[0]);
}

TEST(Blocker, WhosePlaneHoldsTheReceiverHidesNothing) {
  const Ring edge_on = {{-1, 0, 1}, {1, 0, 1}, {1, 0, 3}, {-1, 0, 3}};
  EXPECT_EQ(FromBelow({{edge_on}, {kSource, kLamp}}),
            FromBelow({{kSource, kLamp}}));
}

TEST(Blocker, OnlyItsPartInFrontHides) {
  // A wall through the source: what sticks out behind hides nothing.
  const Ring wall = {{0, -2, 2}, {0, 2, 2}, {1, 2, 6}, {1, -2, 6}};
  const Ring front = {{0, -2, 2}, {0, 2, 2}, {0.5, 2, 4}, {0.5, -2, 4}};
  const Rgb expected = FromBelow({{kSource, kLamp}, {front}});
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {wall}}), expected);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {Reversed(wall)}}), expected);
  EXPECT_NE(expected, FromBelow({{kSource, kLamp}}));
}

TEST(Blocker, TrianglesOfASplitFaceHideEachOther) {
  // Two triangles of one bent quad, one in front of the other.
  const Ring bent = {{-2, -2, 4}, {-2, 2, 4}, {2, 2, 4}, {1, -1, 1}};
  const Scene scene = MakeScene({{bent, kLamp}});
  ASSERT_EQ(scene.facets().size(), 2U);
  const auto triangle = [&scene](std::size_t t) {
    Ring ring;
    for (const int v : scene.triangles()[t].vertices) {
      ring.push_back(scene.vertices()[static_cast<std::size_t>(v)]);
    }
    return ring;
  };
  const Receiver r{{-1, 1, 0}, {0, 0, 1}, 0};
  EXPECT_EQ(
      Evaluate(scene, r),
      Evaluate(MakeScene({{triangle(0), kLamp}, {triangle(1), kLamp}}), r));
}

TEST(InnerEdge, IsLeftOutOnlyBetweenBlockersOnOppositeSides) {
  // A folded pair: both triangles on the same side of their common edge. The
  // common edge is a silhouette.
  const Ring a = {{0, -1, 2}, {0, 1, 2}, {1, 0, 2}};
  const Ring b = {{0, -1, 2}, {0, 1, 2}, {1.5, 0, 3}};
  const Rgb folded = FromBelow({{kSource, kLamp}, {a}, {b}});
  EXPECT_EQ(folded, FromBelow({{kSource, kLamp}, {a}}));
  // Unfolded, the edge is inner and the pair hides what the quad hides.
  const Ring c = {{0, -1, 2}, {0, 1, 2}, {-1, 0, 2}};
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {a}, {c}}),
            FromBelow({{kSource, kLamp},
                       {{{0, -1, 2}, {1, 0, 2}, {0, 1, 2}, {-1, 0, 2}}}}));
}

TEST(InnerEdge, StaysWhereTheNeighbourDoesNotBlockThisSource) {
  // The neighbour of `a` lies behind the source's plane.
  const Ring a = {{0, -1, 3.5}, {0, 1, 3.5}, {1, 0, 3}};
  const Ring behind = {{0, -1, 3.5}, {0, 1, 3.5}, {-1, 0, 6}};
  const Ring source = Ceiling(-2, 2, -2, 2, 3.5);
  EXPECT_EQ(FromBelow({{source, kLamp}, {a}, {behind}}),
            FromBelow({{source, kLamp}, {a}}));
  // The neighbour's plane holds the receiver.
  const Ring edge_on = {{0, -1, 3}, {0, 1, 3}, {0, 0, 2}};
  const Ring b = {{0, -1, 3}, {0, 1, 3}, {1, 0, 3}};
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {b}, {edge_on}}),
            FromBelow({{kSource, kLamp}, {b}}));
}

TEST(InnerEdge, IsFoundByPositionAndByWholeEdgesOnly) {
  // A T-junction: the left triangle's edge is twice as long.
  const Ring left = {{0, -1, 2}, {0, 1, 2}, {-1, 0, 2}};
  const Ring right = {{0, 0, 2}, {0, 1, 2}, {1, 0.5, 2}};
  const Ring same = {{0, -1, 2}, {0, 0, 2}, {0, 1, 2}, {-1, 0, 2}};
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {left}, {right}}),
            FromBelow({{kSource, kLamp}, {same}, {right}}));
}

TEST(Ownership, DuplicatedAndOverlappingEdgesCountOnce) {
  const Ring square = Ceiling(-1, 1, -1, 1, 2);
  const Rgb once = FromBelow({{kSource, kLamp}, {square}});
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {square}, {square}}), once);
  EXPECT_EQ(FromBelow({{kSource, kLamp},
                       {square},
                       {Reversed(square)},
                       {Scaled(square, 0.5)}}),
            once);
  // Collinear edges that overlap only in part, from either side.
  const Ring longer = Ceiling(-1, 1, -1, 0.5, 2);
  const Ring shifted = Ceiling(-1, 1, -0.25, 1, 2);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {longer}, {shifted}}), once);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {longer}, {Scaled(shifted, 0.5)}}),
            once);
}

TEST(Interpenetration, EqualsTheSplitScene) {
  // Two emitters cross along x = 0, z = 4.
  const Ring flat = Ceiling(-2, 2, -2, 2, 4);
  const Ring slanted = {{-2, -2, 3}, {-2, 2, 3}, {2, 2, 5}, {2, -2, 5}};
  const Rgb split =
      FromBelow({{{{-2, -2, 3}, {-2, 2, 3}, {0, 2, 4}, {0, -2, 4}}, kLamp},
                 {Ceiling(0, 2, -2, 2, 4), {7, 0, 1}}});
  EXPECT_EQ(FromBelow({{flat, {7, 0, 1}}, {slanted, kLamp}}), split);
  EXPECT_EQ(FromBelow({{slanted, kLamp}, {flat, {7, 0, 1}}}), split);
}

TEST(OnFace, IgnoresThatFaceAndItsPlane) {
  // A floor that a rounded receiver lies just below.
  const Ring floor = Floor(-9, 9, -9, 9, 0);
  const Ring tile = Floor(10, 12, -9, 9, 0);
  const Scene scene = MakeScene({{kSource, kLamp}, {floor}, {tile}});
  const Receiver below{{0, 0, -0x1p-60}, {0, 0, 1}, 0};
  EXPECT_EQ(Evaluate(scene, below), kBlack);
  const Rgb open = Evaluate(MakeScene({{kSource, kLamp}}), below);
  EXPECT_EQ(Evaluate(scene, {below.position, below.normal, 2}), open);
  // The tile names the same plane.
  EXPECT_EQ(Evaluate(scene, {below.position, below.normal, 3}), open);
  EXPECT_EQ(Evaluate(scene, {below.position, below.normal, 1}), kBlack);
}

TEST(Hidden, IsExactlyZeroOnlyWhenNothingShows) {
  const Ring copy = Scaled(kSource, 0.5);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {copy}}), kBlack);
  // One corner of the copy pulled in by one ulp.
  Ring open = copy;
  open[2].x = std::nextafter(open[2].x, 0.0);
  const Rgb slit = FromBelow({{kSource, kLamp}, {open}});
  EXPECT_GT(slit[0], 0);
  EXPECT_LT(slit[0], 1e-15);
  // Pushed out, it hides all the same.
  Ring larger = copy;
  larger[2].x = std::nextafter(larger[2].x, 9.0);
  EXPECT_EQ(FromBelow({{kSource, kLamp}, {larger}}), kBlack);
}

}  // namespace
}  // namespace truelux
