// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_access.h"

#include <gtest/gtest.h>

namespace truelux {
namespace {

/// A triangle and a square; the square has two triangles.
Scene TwoFaces() {
  SceneBuilder builder;
  builder.AddFace({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}, {1, 2, 3});
  builder.AddFace({{0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2}});
  return *builder.Build().value;
}

TEST(SceneAccess, ShowsThePublicArrays) {
  const Scene scene = TwoFaces();
  EXPECT_EQ(VerticesOf(scene).size(), scene.vertices().size());
  EXPECT_EQ(&VerticesOf(scene)[VertexId(6)], &scene.vertices()[6]);
  EXPECT_EQ(&TrianglesOf(scene)[TriangleId(2)], &scene.triangles()[2]);
  EXPECT_EQ(&FacetsOf(scene)[FacetId(1)], &scene.facets()[1]);
  EXPECT_EQ(&FacesOf(scene)[FaceId(0)], &scene.faces()[0]);
}

TEST(SceneAccess, LeadsFromTrianglesToFacesAndBack) {
  const Scene scene = TwoFaces();
  ASSERT_EQ(TrianglesOf(scene).size(), 3U);
  EXPECT_EQ(FacetOf(TrianglesOf(scene)[TriangleId(2)]), FacetId(1));
  EXPECT_EQ(FaceOf(scene, FacetId(1)), FaceId(1));
  EXPECT_EQ(NumberOf(FaceOf(scene, FacetId(1))), FaceNumber(2));
  const Facet& square = FacetsOf(scene)[FacetId(1)];
  EXPECT_EQ(FirstTriangleOf(square), TriangleId(1));
  ASSERT_EQ(TrianglesOf(scene, square).size(), 2U);
  EXPECT_EQ(&TrianglesOf(scene, square)[0], &scene.triangles()[1]);
  int facets = 0;
  for (const FacetId facet : FacetsOf(FacesOf(scene)[FaceId(1)])) {
    EXPECT_EQ(facet, FacetId(1));
    ++facets;
  }
  EXPECT_EQ(facets, 1);
}

}  // namespace
}  // namespace truelux
