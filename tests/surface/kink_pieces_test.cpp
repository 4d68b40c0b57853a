// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a surface the gradient jumps: known answers.

#include "surface/kink_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "support/scenes.h"
#include "surface/ground.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Rgb kUnit = {1, 1, 1};

/// The kink across x = 0 at (0, y) by the oracle; 0 without one.
Rgb KinkAcrossX(const Scene& scene, double y) {
  const Derivatives derivatives =
      Oracle(scene).Derivatives(Receiver{{0, y, 0}, {0, 0, 1}, 1});
  for (const Kink& kink : derivatives.kinks) {
    if (kink.normal == Vector3{1, 0, 0}) return kink.size;
  }
  return {};
}

void ExpectPieceAtX0(const KinkPiece& piece, const mpq_class& from,
                     const mpq_class& to) {
  EXPECT_EQ(piece.from.y, from);
  EXPECT_EQ(piece.to.y, to);
  EXPECT_EQ(piece.from.x, 0);
  EXPECT_EQ(piece.from.z, 0);
}

const TestFace kLampAbove = {Ceiling(-2, 2, -1, 1, 4), kUnit};

// Edges over x = 0 from y = -1 to 1 at the heights 1 and 2, as in case K02.
TEST(KinkPieces, TwoParallelEdgesBeforeALamp) {
  const Ground ground(
      {kLampAbove, {Ceiling(0, 1, -1, 1, 1)}, {Ceiling(0, 1, -1, 1, 2)}});
  const auto pieces = ground.PiecesAtX0();
  // Both appear before the lamp where (-1 - y) / 4 < 1 - y, y < 5 / 3.
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().from.y, mpq_class(-5, 3));
  EXPECT_EQ(pieces.back().to.y, mpq_class(5, 3));
  EXPECT_EQ(pieces.size(), 1U);
  ExpectNear(pieces[0].size, KinkAcrossX(ground.scene(), 0));
  EXPECT_GT(std::fabs(pieces[0].size[0]), 1e-3);
  EXPECT_TRUE(pieces[0].faces.empty());
  ASSERT_EQ(pieces[0].edges.size(), 2U);
  EXPECT_NE(pieces[0].edges[0], pieces[0].edges[1]);
  EXPECT_TRUE(ground.PiecesAtX0(true).empty());
}

TEST(KinkPieces, PartsOfATraceAreCutThere) {
  const Ground ground(
      {kLampAbove, {Ceiling(0, 1, -1, 1, 1)}, {Ceiling(0, 1, -1, 1, 2)}});
  const std::size_t plane = ground.PlaneOf({1, 0, 0}, 0);
  const auto part = ground.Pieces(plane, PointOf(0, 1), PointOf(0, -1));
  ASSERT_EQ(part.size(), 1U);
  ExpectPieceAtX0(part[0], 1, -1);
  ExpectNear(part[0].size, KinkAcrossX(ground.scene(), 0));
  EXPECT_TRUE(
      ground.Pieces(plane, PointOf(0, mpq_class(5, 3)), PointOf(0, 7)).empty());
  EXPECT_THROW(
      static_cast<void>(ground.Pieces(plane, PointOf(0, 1), PointOf(1, 1))),
      std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(ground.Pieces(plane, PointOf(0, 1), PointOf(0, 1))),
      std::invalid_argument);
}

// Edges that are one behind the other from other places only.
TEST(KinkPieces, CausesCutAPiece) {
  const Ground ground({kLampAbove,
                       {Ceiling(0, 1, -1, 1, 1)},
                       {Ceiling(0, 1, -1, 0, 2)},
                       {Ceiling(-1, 0, 0, 1, 2)}});
  const auto pieces = ground.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 3U);
  // The near edge hides the end at y = 0 of both far ones for |y| < 2, and the
  // lamp ends at y = -1 and 1, at the height 4.
  ExpectPieceAtX0(pieces[0], mpq_class(-5, 3), -1);
  ExpectPieceAtX0(pieces[1], -1, 1);
  ExpectPieceAtX0(pieces[2], 1, mpq_class(5, 3));
  EXPECT_EQ(pieces[0].edges.size(), 2U);
  EXPECT_EQ(pieces[1].edges.size(), 3U);
  EXPECT_EQ(pieces[2].edges.size(), 2U);
  // Far edges of opposite sides cancel in the middle, and only there.
  EXPECT_EQ(pieces[1].size, Rgb{});
  EXPECT_NE(pieces[0].size, Rgb{});
}

// A wall in x = 0 that stays above the ground.
TestFace WallAbove(const Rgb& front) {
  return {{{0, -0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1.5}, {0, -0.5, 1.5}}, front};
}

TEST(KinkPieces, AFaceSeenEdgeOn) {
  const Ground ground({kLampAbove, WallAbove({})});
  const auto pieces = ground.PiecesAtX0();
  // The lamp's end (1, 4) is over the wall's ends (-1/2, 3/2) and (-1/2, 1), its
  // other end likewise: sides of the wall are before the lamp, or not.
  const std::vector<mpq_class> ends = {mpq_class(-7, 5), -1, mpq_class(-1, 5),
                                       mpq_class(1, 5),  1,  mpq_class(7, 5)};
  ASSERT_EQ(pieces.size() + 1, ends.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ExpectPieceAtX0(pieces[i], ends[i], ends[i + 1]);
    EXPECT_EQ(pieces[i].faces, std::vector<int>{3});
  }
  ExpectNear(pieces[2].size, KinkAcrossX(ground.scene(), 0));
}

TEST(KinkPieces, AFaceThatEmitsTwiceWhatIsBehindItIsNone) {
  // The lamp fills all that the wall is before.
  const TestFace lamp = {Ceiling(-9, 9, -90, 90, 4), kUnit};
  EXPECT_TRUE(Ground({lamp, WallAbove({2, 2, 2})}).PiecesAtX0().empty());
  EXPECT_FALSE(Ground({lamp, WallAbove({1, 1, 1})}).PiecesAtX0().empty());
  const Ground some({lamp, WallAbove({1, 2, 3})});
  const auto pieces = some.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size[1], 0);
  ExpectNear(pieces[0].size, KinkAcrossX(some.scene(), 0));
}

TEST(KinkPieces, AFarLineThatBoundsNoLightIsNone) {
  // The blocker far away has nothing behind it, or ends where its like begins.
  EXPECT_TRUE(Ground({{Ceiling(2, 3, -1, 1, 4), kUnit},
                      {Ceiling(0, 1, -1, 1, 1)},
                      {Ceiling(0, 1, -1, 1, 2)}})
                  .PiecesAtX0()
                  .empty());
  EXPECT_TRUE(Ground({{Ceiling(0, 2, -1, 1, 4), kUnit},
                      {Ceiling(-2, 0, -1, 1, 4), kUnit},
                      {Ceiling(0, 1, -1, 1, 1)}})
                  .PiecesAtX0()
                  .empty());
  EXPECT_FALSE(Ground({{Ceiling(0, 2, -1, 1, 4), kUnit},
                       {Ceiling(-2, 0, -1, 1, 4), {2, 1, 1}},
                       {Ceiling(0, 1, -1, 1, 1)}})
                   .PiecesAtX0()
                   .empty());
}

TEST(KinkPieces, AThirdFaceHides) {
  std::vector<TestFace> faces = {kLampAbove,
                                 {Ceiling(0, 1, -1, 1, 1)},
                                 {Ceiling(0, 1, -1, 1, 2)},
                                 {Ceiling(-1, 1, -9, 9, 0.5)}};
  EXPECT_TRUE(Ground(faces).PiecesAtX0().empty());
  // A half of it: from y = 0 it hides what lies at y > 0.
  faces[3] = {Ceiling(-1, 1, 0, 9, 0.5)};
  const auto pieces = Ground(faces).PiecesAtX0();
  ASSERT_EQ(pieces.size(), 1U);
  ExpectPieceAtX0(pieces[0], mpq_class(-5, 3), mpq_class(1, 7));
}

// The second line of the plane is far away.
TEST(KinkPieces, AnInnerDiagonalIsNone) {
  Ring kite = {{-1, -1, 4}, {0, 1, 4}, {1, -1, 4}, {0, -2, 4}};
  for (int start = 0; start < 4; ++start) {
    const Ground ground(
        {{kite, kUnit}, {Ceiling(0, 1, -1, 1, 1)}, {Ceiling(0, 1, 30, 31, 2)}});
    EXPECT_TRUE(ground.PiecesAtX0().empty());
    std::rotate(kite.begin(), kite.begin() + 1, kite.end());
  }
}

// It would be a kink if the lamp had two halves.
TEST(KinkPieces, FacesSideBySideAreAsOneIfTheyEmitTheSame) {
  const auto pieces_with = [](const Rgb& emission) {
    return Ground({{Ceiling(-2, 0, -1, 1, 4), emission},
                   {Ceiling(0, 2, -1, 1, 4), kUnit},
                   {Ceiling(0, 1, -1, 1, 1)}})
        .PiecesAtX0();
  };
  EXPECT_TRUE(pieces_with(kUnit).empty());
  const auto pieces = pieces_with({1, 2, 1});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size[0], 0);
  EXPECT_NE(pieces[0].size[1], 0);
}

// A wall through the lamp z = 4 at x = 0, and an edge at x = 0, z = 1.
TEST(KinkPieces, AnEdgeOverALineWhereALampIsPierced) {
  const Ground ground(
      {{Ceiling(-3, 3, -1, 1, 4), kUnit},
       {{{-1, -0.5, 3}, {-1, 0.5, 3}, {1, 0.5, 5}, {1, -0.5, 5}}},
       {Ceiling(-1, 0, -1, 1, 1)}});
  const auto pieces = ground.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 1U);
  // The end (1/2, 4) of the wall over the end (-1, 1) of the edge.
  ExpectPieceAtX0(pieces[0], mpq_class(-3, 2), mpq_class(3, 2));
  ExpectNear(pieces[0].size, KinkAcrossX(ground.scene(), 0));
  EXPECT_EQ(pieces[0].edges.size(), 1U);
}

// The same with a steep lamp: the line meets the ground at y = -1, and from
// there the lamp is seen on either side.
TEST(KinkPieces, ACutIsSeenFromBothSidesOfItsFoot) {
  const auto at = [](double x, double y, double up) {
    return Point3{x, y, 4 + 4 * y + up * x};
  };
  const Ring lamp = {at(-3, -0.5, 0), at(-3, 0.5, 0), at(3, 0.5, 0),
                     at(3, -0.5, 0)};
  int kinks_before = 0;
  int kinks_behind = 0;
  for (const double up : {-1, 1}) {
    for (const Ring& ring : {lamp, Reversed(lamp)}) {
      const Ground ground({{ring, kUnit},
                           {{at(-1, -0.5, up), at(-1, 0.5, up), at(1, 0.5, up),
                             at(1, -0.5, up)}},
                           {Ceiling(-1, 0, -2, 1, 1)}});
      const std::size_t plane = ground.PlaneOf({1, 0, 0}, 0);
      for (int i = -15; i < 16; i += 2) {
        const double y = 0.25 * i;
        const mpq_class reach = mpq_class(1) / 1024;
        const auto pieces =
            ground.Pieces(plane, PointOf(0, y - reach), PointOf(0, y + reach));
        ASSERT_LE(pieces.size(), 1U) << y;
        const Rgb expected = KinkAcrossX(ground.scene(), y);
        EXPECT_EQ(pieces.empty(), expected == Rgb{}) << y;
        if (pieces.empty()) continue;
        ExpectNear(pieces[0].size, expected);
        ++(y < -1 ? kinks_before : kinks_behind);
      }
    }
  }
  EXPECT_GT(kinks_before, 2);
  EXPECT_GT(kinks_behind, 2);
}

TEST(KinkPieces, FacesThatEmitToBothSides) {
  SceneBuilder builder("scene");
  builder.SetTwoSided(true);
  for (const TestFace& face : {GroundFace(), kLampAbove, WallAbove({1, 2, 0.5}),
                               TestFace{Floor(-3, 0, -1, 1, 5), {2, 2, 2}},
                               TestFace{Ceiling(-1, 0, -1, 1, 3)}}) {
    builder.AddFace(face.ring, face.emission);
  }
  const Ground ground(*builder.Build().value);
  const auto pieces = ground.PiecesAtX0();
  const auto middle = std::ranges::find_if(pieces, [](const KinkPiece& piece) {
    return piece.from.y < 0 && piece.to.y > 0;
  });
  ASSERT_NE(middle, pieces.end());
  ASSERT_EQ(middle->from.y, -middle->to.y);
  ExpectNear(middle->size, KinkAcrossX(ground.scene(), 0));
  EXPECT_EQ(middle->faces, std::vector<int>{3});
}

/// Turned and three times as large.
Point3 Turned(const Point3& p) {
  return {2 * p.x - p.y + 2 * p.z, 2 * p.x + 2 * p.y - p.z,
          2 * p.y + 2 * p.z - p.x};
}

TEST(KinkPieces, ASurfaceMayLieAnywhereAndLookToEitherSide) {
  const std::vector<TestFace> above = {
      kLampAbove, WallAbove({}), {Ceiling(0, 1, -1, 1, 0.5), {0, 1, 0}}};
  const auto pieces = Ground(above).PiecesAtX0();
  ASSERT_GT(pieces.size(), 2U);
  std::vector<TestFace> turned = {{Reversed(GroundFace().ring)}};
  turned.insert(turned.end(), above.begin(), above.end());
  for (TestFace& face : turned) {
    for (Point3& p : face.ring)
      p = Turned(p);
  }
  const Scene scene = MakeScene(turned);
  const std::array<int, 1> faces = {0};
  std::string defect;
  const SurfaceFrame frame = SurfaceFrameOf(scene, faces, defect).value();
  const EdgePlanes planes =
      EdgePlanesOf(scene, {{{0, 0, 0}, Turned({1, 0, 0}), Turned({0, 1, 0})}});
  const auto plane =
      std::ranges::find_if(planes.planes, [](const EdgePlane& candidate) {
        return candidate.normal.x == 2 && candidate.normal.y == 2 &&
               candidate.normal.z == -1 && candidate.offset == 0;
      });
  ASSERT_NE(plane, planes.planes.end());
  const auto pieces_of = [&](bool reversed_side) {
    return KinkPiecesOf(scene, frame, planes,
                        static_cast<std::size_t>(plane - planes.planes.begin()),
                        RationalOf(Turned({0, -8, 0})),
                        RationalOf(Turned({0, 8, 0})), reversed_side);
  };
  EXPECT_TRUE(pieces_of(false).empty());
  const auto others = pieces_of(true);
  ASSERT_EQ(others.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(others[i].from.x, -pieces[i].from.y);
    EXPECT_EQ(others[i].to.z, 2 * pieces[i].to.y);
    EXPECT_EQ(others[i].faces, pieces[i].faces);
    EXPECT_EQ(others[i].edges.size(), pieces[i].edges.size());
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(3 * others[i].size[k], pieces[i].size[k],
                  2e-12 * std::fabs(pieces[i].size[k]));
    }
  }
}

TEST(KinkPieces, WhereAFaceStandsOnTheSurfaceThereIsNone) {
  const TestFace wall = {{{0, -1, 0}, {0, 1, 0}, {0, 1, 2}, {0, -1, 2}}};
  const Ground ground({kLampAbove, wall});
  const auto pieces = ground.PiecesAtX0();
  ASSERT_EQ(pieces.size(), 2U);
  // The lamp's end at (-1, 4) over the wall's top at (1, 2): y = 3.
  ExpectPieceAtX0(pieces[0], -3, -1);
  ExpectPieceAtX0(pieces[1], 1, 3);
  ExpectNear(pieces[1].size, KinkAcrossX(ground.scene(), 2));
}

}  // namespace
}  // namespace truelux
