// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes as convex pieces: which facets become one, and which edges are one.

#include "scene/index/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "scene/scene_access.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

Scene SceneOf(const std::vector<std::vector<Point3>>& rings) {
  SceneBuilder builder;
  for (const auto& ring : rings)
    builder.AddFace(ring);
  Result<Scene> scene = builder.Build();
  EXPECT_TRUE(scene.ok());
  return *scene.value;
}

const std::vector<Point3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(ConvexPieces, AStrictlyConvexFaceIsOnePiece) {
  const Scene scene = SceneOf({kSquare,
                               {{0, 0, 1},
                                {2, 0, 1},
                                {3, 1, 1},
                                {2, 2, 1},
                                {0, 2, 1},
                                {-1, 1, 1},
                                {-0.75, 0.5, 1}}});
  const ConvexPieces pieces(scene);
  ASSERT_EQ(pieces.pieces().size(), 2U);
  EXPECT_EQ(pieces.pieces()[PieceId(0)].corner_count, 4);
  EXPECT_EQ(pieces.pieces()[PieceId(1)].corner_count, 7);
  EXPECT_EQ(pieces.PiecesOf(FacetId(1)).size(), 1);
  // The ring runs as the face does: each corner is the square's next one.
  const auto ring = pieces.CornersOf(pieces.pieces()[PieceId(0)]);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3& at = VerticesOf(scene)[ring[k]];
    const Point3& next = VerticesOf(scene)[ring[(k + 1) % 4]];
    const auto place = std::ranges::find(kSquare, at) - kSquare.begin();
    EXPECT_EQ(next, kSquare[static_cast<std::size_t>((place + 1) % 4)]);
  }
}

struct PiecesCase {
  const char* what;
  std::vector<Point3> ring;
  std::vector<int> corners;  ///< of the pieces, sorted
};

class SeveralPieces : public ::testing::TestWithParam<PiecesCase> {};

TEST_P(SeveralPieces, HaveSoManyCorners) {
  const ConvexPieces pieces(SceneOf({GetParam().ring}));
  std::vector<int> corners;
  for (const Piece& piece : pieces.pieces())
    corners.push_back(piece.corner_count);
  std::ranges::sort(corners);
  EXPECT_EQ(corners, GetParam().corners) << GetParam().what;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SeveralPieces,
    ::testing::Values(
        PiecesCase{"a triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {3}},
        PiecesCase{
            "an arrow", {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}}, {3, 3}},
        PiecesCase{"a corner of 180 degrees",
                   {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                   {3, 4}},
        PiecesCase{"a corner one ulp inward",
                   {{0, 0, 0}, {1, 0x1p-52, 0}, {2, 0, 0}, {0, 2, 0}},
                   {3, 3}},
        PiecesCase{"eight corners",
                   {{2, 0, 0},
                    {4, 0, 0},
                    {6, 2, 0},
                    {6, 4, 0},
                    {4, 6, 0},
                    {2, 6, 0},
                    {0, 4, 0},
                    {0, 2, 0}},
                   {3, 7}},
        PiecesCase{
            "an L",
            {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
            {4, 4}}),
    [](const auto& tested) { return "Case" + std::to_string(tested.index); });

/// Twice the signed area of a ring in the plane z = 0; exact for small integers.
double TwiceArea(const Scene& scene, std::span<const VertexId> ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto at = [&](std::size_t i) {
      return VerticesOf(scene)[ring[i % ring.size()]];
    };
    sum += at(k).x * at(k + 1).y - at(k + 1).x * at(k).y;
  }
  return sum;
}

TEST(ConvexPieces, OfStarsAreConvexAndTileThem) {
  testing::PortableRandom random(5);
  std::size_t triangles = 0;
  std::size_t pieces_of_all = 0;
  for (int round = 0; round < 300; ++round) {
    // A star on a lattice: one corner in each of `count` directions.
    const int count = 5 + round % 28;
    std::vector<Point3> ring;
    for (int k = 0; k < count; ++k) {
      const double turn = 2 * std::numbers::pi * k / count;
      const double length = 1000 + 9000 * random.Unit();
      ring.push_back({std::round(length * std::cos(turn)),
                      std::round(length * std::sin(turn)), 0});
    }
    const Scene scene = SceneOf({ring});
    const ConvexPieces pieces(scene);
    triangles += scene.triangles().size();
    pieces_of_all += pieces.pieces().size();
    double sum = 0;
    for (const Piece& piece : pieces.pieces()) {
      const auto corners = pieces.CornersOf(piece);
      sum += TwiceArea(scene, corners);
      ASSERT_LE(piece.corner_count, ConvexPieces::kMaxCorners);
      for (int k = 0; k < piece.corner_count; ++k) {
        const auto n = static_cast<std::size_t>(piece.corner_count);
        const auto i = static_cast<std::size_t>(k);
        const std::array<VertexId, 3> turn{corners[i], corners[(i + 1) % n],
                                           corners[(i + 2) % n]};
        ASSERT_GT(TwiceArea(scene, turn), 0) << "round " << round;
      }
    }
    std::vector<VertexId> corners;
    for (int k = 0; k < scene.faces()[0].corner_count; ++k)
      corners.emplace_back(scene.corners()[static_cast<std::size_t>(k)]);
    EXPECT_EQ(sum, TwiceArea(scene, corners));
  }
  // Random stars have reflex corners, but joining pays.
  EXPECT_LT(pieces_of_all, triangles * 6 / 10);
}

TEST(ConvexPieces, MaxCornersOfThreeLeavesTriangles) {
  const Scene scene = SceneOf({kSquare});
  EXPECT_EQ(ConvexPieces(scene, 3).pieces().size(), 2U);
}

TEST(ConvexPieces, ACornerOneUlpOutwardIsConvex) {
  const ConvexPieces pieces(
      SceneOf({{{0, 0, 0}, {1, -0x1p-52, 0}, {2, 0, 0}, {0, 2, 0}}}));
  EXPECT_EQ(pieces.pieces().size(), 1U);
}

TEST(ConvexPieces, SameEdgesAreLinkedWhateverTheirDirection) {
  // Three squares on the edge (0,0,0)-(0,1,0), the third the other way round.
  const Scene scene = SceneOf({kSquare,
                               {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}},
                               {{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}}});
  const ConvexPieces pieces(scene);
  ASSERT_EQ(pieces.pieces().size(), 3U);
  ASSERT_EQ(pieces.corners().size(), 12U);
  int shared = 0;
  for (const EdgeId edge : pieces.corners().ids()) {
    std::set<PieceId> owners{pieces.PieceOf(edge)};
    for (EdgeId other = pieces.NextSameEdge(edge); other != edge;
         other = pieces.NextSameEdge(other)) {
      EXPECT_TRUE(owners.insert(pieces.PieceOf(other)).second);
    }
    EXPECT_TRUE(owners.size() == 1 || owners.size() == 3);
    if (owners.size() == 3) ++shared;
  }
  EXPECT_EQ(shared, 3);
}

TEST(ConvexPieces, KnowConnectedCoplanarFaces) {
  // Three squares in a row, the second tilted by one ulp; a fourth coplanar
  // with the first, on the other side; a fifth in the plane, but apart.
  const double up = 0x1p-52;
  const Scene scene = SceneOf({kSquare,
                               {{1, 0, 0}, {2, 0, up}, {2, 1, up}, {1, 1, 0}},
                               {{2, 0, up}, {3, 0, up}, {3, 1, up}, {2, 1, up}},
                               {{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}},
                               {{5, 5, 0}, {6, 5, 0}, {6, 6, 0}}});
  const ConvexPieces pieces(scene);
  for (const int apart : {0, 1, 2, 4})
    EXPECT_EQ(pieces.FirstInPlaneOf(FacetId(apart)), FacetId(apart));
  EXPECT_EQ(pieces.FirstInPlaneOf(FacetId(3)), FacetId(0));
}

TEST(ConvexPieces, AnEmptySceneHasNone) {
  EXPECT_TRUE(ConvexPieces(Scene()).pieces().empty());
}

}  // namespace
}  // namespace truelux
