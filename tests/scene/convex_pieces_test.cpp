// Scenes as convex pieces: which facets become one, and which edges are one.

#include "scene/convex_pieces.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

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
  EXPECT_EQ(pieces.pieces()[0].corner_count, 4);
  EXPECT_EQ(pieces.pieces()[1].corner_count, 7);
  EXPECT_EQ(pieces.PiecesOf(1).size(), 1U);
  // The ring runs as the face does: each corner is the square's next one.
  const auto ring = pieces.CornersOf(pieces.pieces()[0]);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3& at = scene.vertices()[static_cast<std::size_t>(ring[k])];
    const Point3& next =
        scene.vertices()[static_cast<std::size_t>(ring[(k + 1) % 4])];
    const auto place = std::ranges::find(kSquare, at) - kSquare.begin();
    EXPECT_EQ(next, kSquare[static_cast<std::size_t>((place + 1) % 4)]);
  }
}

struct TriangleCase {
  const char* what;
  std::vector<Point3> ring;
  std::size_t pieces;
};

class LeftAsTriangles : public ::testing::TestWithParam<TriangleCase> {};

TEST_P(LeftAsTriangles, OnePieceEach) {
  const Scene scene = SceneOf({GetParam().ring});
  const ConvexPieces pieces(scene);
  EXPECT_EQ(pieces.pieces().size(), GetParam().pieces);
  for (const Piece& piece : pieces.pieces())
    EXPECT_EQ(piece.corner_count, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, LeftAsTriangles,
    ::testing::Values(
        TriangleCase{"a triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1},
        TriangleCase{
            "an arrow", {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}}, 2},
        TriangleCase{"a corner of 180 degrees",
                     {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                     3},
        TriangleCase{"a corner one ulp inward",
                     {{0, 0, 0}, {1, 0x1p-52, 0}, {2, 0, 0}, {0, 2, 0}},
                     2},
        TriangleCase{"eight corners",
                     {{2, 0, 0},
                      {4, 0, 0},
                      {6, 2, 0},
                      {6, 4, 0},
                      {4, 6, 0},
                      {2, 6, 0},
                      {0, 4, 0},
                      {0, 2, 0}},
                     6}),
    [](const auto& tested) { return "Case" + std::to_string(tested.index); });

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
  int shared = 0;
  for (int edge = 0; edge < 12; ++edge) {
    std::set<int> owners{pieces.PieceOf(edge)};
    for (int other = pieces.NextSameEdge(edge); other != edge;
         other = pieces.NextSameEdge(other)) {
      EXPECT_TRUE(owners.insert(pieces.PieceOf(other)).second);
    }
    EXPECT_TRUE(owners.size() == 1 || owners.size() == 3);
    if (owners.size() == 3) ++shared;
  }
  EXPECT_EQ(shared, 3);
}

TEST(ConvexPieces, CoplanarFacesThatAreConnectedHaveOneNumber) {
  // Three squares in a row, the second tilted by one ulp; a fourth coplanar
  // with the first, on the other side; a fifth in the plane, but apart.
  const double up = 0x1p-52;
  const Scene scene = SceneOf({kSquare,
                               {{1, 0, 0}, {2, 0, up}, {2, 1, up}, {1, 1, 0}},
                               {{2, 0, up}, {3, 0, up}, {3, 1, up}, {2, 1, up}},
                               {{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}},
                               {{5, 5, 0}, {6, 5, 0}, {6, 6, 0}}});
  const ConvexPieces pieces(scene);
  EXPECT_EQ(pieces.PlaneNumber(0), pieces.PlaneNumber(3));
  EXPECT_NE(pieces.PlaneNumber(0), pieces.PlaneNumber(1));
  EXPECT_NE(pieces.PlaneNumber(1), pieces.PlaneNumber(2));
  EXPECT_NE(pieces.PlaneNumber(0), pieces.PlaneNumber(4));
}

TEST(ConvexPieces, AnEmptySceneHasNone) {
  EXPECT_TRUE(ConvexPieces(Scene()).pieces().empty());
}

}  // namespace
}  // namespace truelux
