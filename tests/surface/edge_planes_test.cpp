// SPDX-License-Identifier: GPL-3.0-or-later
// Which planes edges of a scene have in common.

#include "surface/edge_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr std::array<Point3, 3> kFloor = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

bool HasPlane(const EdgePlanes& found, const std::array<int, 3>& normal,
              const mpq_class& offset) {
  return std::ranges::any_of(found.planes, [&](const EdgePlane& plane) {
    return plane.normal.x == normal[0] && plane.normal.y == normal[1] &&
           plane.normal.z == normal[2] && plane.offset == offset;
  });
}

TEST(EdgePlanes, ATetrahedronHasItsFourFacesOnly) {
  // Opposite edges are skew.
  const Scene scene = SceneFromText(
      "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\n"
      "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n");
  const EdgePlanes found = EdgePlanesOf(scene, kFloor);
  EXPECT_TRUE(found.is_complete);
  EXPECT_EQ(found.edges.size(), 6U);
  EXPECT_EQ(found.edges_of_line.size(), 6U);
  EXPECT_EQ(found.planes.size(), 4U);
  EXPECT_TRUE(HasPlane(found, {0, 0, 1}, 1));
  EXPECT_TRUE(HasPlane(found, {1, 1, 1}, 2));
  for (const EdgePlane& plane : found.planes)
    EXPECT_EQ(plane.lines.size(), 3U);
}

TEST(EdgePlanes, ACubeHasPlanesOfItsParallelEdges) {
  // Its bottom lies in the surface: the four edges there do not count.
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"
      "v 0 1 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n");
  const EdgePlanes found = EdgePlanesOf(scene, kFloor);
  EXPECT_EQ(found.edges.size(), 8U);
  // Five faces and two diagonal planes of upright edges.
  EXPECT_EQ(found.planes.size(), 7U);
  EXPECT_TRUE(HasPlane(found, {1, 1, 0}, 1));
  EXPECT_TRUE(HasPlane(found, {1, -1, 0}, 0));
}

TEST(EdgePlanes, EdgesOnOneLineMakeNoPlane) {
  const Scene scene = SceneFromText(
      "v 0 0 1\nv 1 0 1\nv 0 1 2\nv 2 0 1\nv 3 0 1\nv 2 1 3\n"
      "f 1 2 3\nf 4 5 6\n");
  const EdgePlanes found = EdgePlanesOf(scene, kFloor);
  EXPECT_EQ(found.edges.size(), 6U);
  EXPECT_EQ(found.edges_of_line.size(), 5U);
  // The faces, and a plane for each pair of their other edges that meets by
  // accident: none here.
  EXPECT_EQ(found.planes.size(), 2U);
}

TEST(EdgePlanes, AnUlpOffThePlaneIsOff) {
  const std::string face = "v 0 0 1\nv 1 0 1\nv 0.25 3 7\nf -1 -2 -3\n";
  // Edges from (0, 0, 2) and from beside it, parallel to the first one or not.
  const Scene parallel =
      SceneFromText(face + "v 0 0 2\nv 1 0 2\nv 5 9 8\nf -1 -2 -3\n");
  const Scene oblique = SceneFromText(
      face + "v 0 0 2\nv 1 4.9406564584124654e-324 2\nv 5 9 8\nf -1 -2 -3\n");
  EXPECT_TRUE(HasPlane(EdgePlanesOf(parallel, kFloor), {0, 1, 0}, 0));
  EXPECT_FALSE(HasPlane(EdgePlanesOf(oblique, kFloor), {0, 1, 0}, 0));
}

TEST(EdgePlanes, ManyLinesArePairedAtVertices) {
  const Scene scene = SceneFromText(
      "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\nv 5 0 3\nv 6 0 3\nv 7 7 7\n"
      "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\nf 5 6 7\n");
  const EdgePlanes all = EdgePlanesOf(scene, kFloor);
  const EdgePlanes some = EdgePlanesOf(scene, kFloor, 8);
  EXPECT_TRUE(all.is_complete);
  EXPECT_FALSE(some.is_complete);
  // The face y = 0 holds an edge of the other part, which is no neighbour.
  EXPECT_EQ(some.planes.size(), 5U);
  EXPECT_GE(all.planes.size(), 5U);
  for (const EdgePlane& plane : some.planes)
    EXPECT_EQ(plane.lines.size(), 3U);
  const auto y = std::ranges::find_if(all.planes, [](const EdgePlane& plane) {
    return plane.normal.x == 0 && plane.normal.y == 1 && plane.normal.z == 0;
  });
  ASSERT_NE(y, all.planes.end());
  EXPECT_EQ(y->lines.size(), 4U);
}

// A lamp in z = 4 that a wall through x = 2 pierces, and a face with an edge in
// x = 1, z = 2.
Scene PiercedLamp(const std::string& emission) {
  return SceneFromText(
      "v -5 -1 4\nv -5 3 4\nv 5 3 4\nv 5 -1 4\nv 1 0 3\nv 1 1 3\nv 3 1 5\n"
      "v 3 0 5\nv 1 0 2\nv 1 1 2\nv 0 1 1\n"
      "usemtl m\nf 1 2 3 4\nusemtl black\nf 5 6 7 8\nf 9 10 11\n",
      "newmtl m\nKe " + emission + "\nnewmtl black\nKe 0 0 0\n");
}

TEST(EdgePlanes, ALineWhereALampIsPiercedIsOne) {
  const EdgePlanes found = EdgePlanesOf(PiercedLamp("1 2 3"), kFloor);
  ASSERT_FALSE(found.cuts.empty());
  for (const SceneCut& cut : found.cuts) {
    EXPECT_EQ(cut.line, found.cuts[0].line);
    for (const RationalVector& end : cut.ends) {
      EXPECT_EQ(end.x, 2);
      EXPECT_EQ(end.z, 4);
    }
  }
  const auto line = static_cast<std::size_t>(found.cuts[0].line);
  EXPECT_EQ(found.cuts_of_line[line].size(), found.cuts.size());
  EXPECT_TRUE(found.edges_of_line[line].empty());
  EXPECT_TRUE(HasPlane(found, {2, 0, -1}, 0));
  const EdgePlanes dark = EdgePlanesOf(PiercedLamp("0 0 0"), kFloor);
  EXPECT_TRUE(dark.cuts.empty());
  EXPECT_FALSE(HasPlane(dark, {2, 0, -1}, 0));
}

TEST(EdgePlanes, AFaceThatStandsOnALampCutsNothing) {
  const Scene scene = SceneFromText(
      "v -5 -1 4\nv -5 3 4\nv 5 3 4\nv 5 -1 4\nv 1 0 4\nv 1 1 4\nv 3 1 2\n"
      "usemtl m\nf 1 2 3 4\nusemtl black\nf 5 6 7\n",
      "newmtl m\nKe 1 1 1\nnewmtl black\nKe 0 0 0\n");
  EXPECT_TRUE(EdgePlanesOf(scene, kFloor).cuts.empty());
}

}  // namespace
}  // namespace truelux
