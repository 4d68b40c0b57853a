// SPDX-License-Identifier: GPL-3.0-or-later
// Which pixel of a surface is where: axes, extents, exact centres, holes.

#include "image/surface_pixels.h"

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_text.h"
#include "surface/surface_frame.h"

namespace truelux {
namespace {

std::vector<int> AllFaces(const Scene& scene) {
  std::vector<int> faces(scene.faces().size());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

/// The frame of all faces of a scene; throws if there is none.
SurfaceFrame FrameOfAll(const Scene& scene) {
  std::string defect;
  const auto frame = SurfaceFrameOf(scene, AllFaces(scene), defect);
  if (!frame) throw std::invalid_argument(defect);
  return *frame;
}

std::string DefectOf(const std::string& obj) {
  const Scene scene = SceneFromText(obj);
  std::string defect;
  EXPECT_FALSE(SurfaceFrameOf(scene, AllFaces(scene), defect));
  return defect;
}

TEST(SurfacePixels, AxesRunFromTheFirstCorner) {
  // u = (0, 4, 0), v = (2, 0, 0): looks down, towards -z.
  const Scene scene =
      SceneFromText("v 1 1 3\nv 1 5 3\nv 3 5 3\nv 3 1 3\nf 1 2 3 4\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  EXPECT_EQ(frame.HeightByWidth(), 0.5);
  const SurfacePixels pixels(scene, frame, 4, 2);
  const auto first = pixels.At(0, 0);  // the greatest v
  ASSERT_TRUE(first);
  EXPECT_EQ(first->position, (Point3{2.5, 1.5, 3}));
  EXPECT_EQ(first->normal, (Vector3{0, 0, -1}));
  EXPECT_EQ(first->on_face, 1);
  EXPECT_EQ(pixels.At(3, 0)->position, (Point3{2.5, 4.5, 3}));
  EXPECT_EQ(pixels.At(0, 1)->position, (Point3{1.5, 1.5, 3}));
  EXPECT_EQ(pixels.At(3, 1)->position, (Point3{1.5, 4.5, 3}));
}

TEST(SurfacePixels, DyadicCentresAreExactOnAnObliqueSurface) {
  // A parallelogram with u = (8, 2, 4), v = (-1, 4, 16), far from the origin.
  const Scene scene = SceneFromText(
      "v 1048576.125 -3 7\nv 1048584.125 -1 11\nv 1048583.125 3 27\n"
      "v 1048575.125 1 23\nf 1 2 3 4\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  const SurfacePixels pixels(scene, frame, 64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double a = (x + 0.5) / 64;
      const double b = 1 - (y + 0.5) / 32;
      const auto receiver = pixels.At(x, y);
      ASSERT_TRUE(receiver);
      // All of these products and sums are exact.
      EXPECT_EQ(receiver->position,
                (Point3{1048576.125 + 8 * a - b, -3 + 2 * a + 4 * b,
                        7 + 4 * a + 16 * b}));
    }
  }
}

TEST(SurfacePixels, OddSizesHaveTheMiddleExactly) {
  const Scene scene =
      SceneFromText("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  const SurfacePixels pixels(scene, frame, 31, 31);
  for (int i = 0; i < 31; ++i) {
    EXPECT_EQ(pixels.At(15, i)->position.x, 0);
    EXPECT_EQ(pixels.At(i, 15)->position.y, 0);
    // 2 (i + 1/2) / 31 - 1 = (2 i - 30) / 31, rounded once.
    EXPECT_EQ(pixels.At(i, 0)->position.x, (2 * i - 30) / 31.0);
  }
}

TEST(SurfacePixels, OutsideOfAnLIsTransparentAndItsEdgeIsNot) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  const SurfacePixels even(scene, frame, 4, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(even.At(x, y).has_value(), x == 0 || y == 3) << x << " " << y;
  }
  // Two by two: the centres (1, 1), on the inner corner, (3, 1) and (1, 3), on
  // edges, belong to the surface; (3, 3) does not.
  const SurfacePixels two(scene, frame, 2, 2);
  EXPECT_TRUE(two.At(0, 0));
  EXPECT_FALSE(two.At(1, 0));
  EXPECT_TRUE(two.At(0, 1));
  EXPECT_TRUE(two.At(1, 1));
}

TEST(SurfacePixels, EachPixelHasTheEarliestFaceThatHoldsIt) {
  // Two that overlap, one beside them that looks to the other side.
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n"
      "v 1 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nf 5 6 7 8\n"
      "v 4 0 0\nv 4 1 0\nv 6 1 0\nv 6 0 0\nf 9 10 11 12\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  EXPECT_EQ(frame.reversed, std::vector<int>{2});
  const SurfacePixels pixels(scene, frame, 6, 1);
  std::vector<int> faces;
  for (int x = 0; x < 6; ++x)
    faces.push_back(pixels.At(x, 0)->on_face);
  EXPECT_EQ(faces, (std::vector<int>{1, 1, 2, 2, 3, 3}));
  EXPECT_EQ(pixels.At(0, 0)->normal, (Vector3{0, 0, 1}));
  EXPECT_EQ(pixels.At(5, 0)->normal, (Vector3{0, 0, -1}));
}

TEST(SurfacePixels, FacesWithoutAreaDoNotCount) {
  const Scene scene = SceneFromText(
      "v 0 0 5\nv 1 0 5\nv 2 0 5\nf 1 2 3\n"
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 4 5 6\n");
  const SurfaceFrame frame = FrameOfAll(scene);
  EXPECT_EQ(frame.faces, std::vector<int>{1});
  EXPECT_EQ(SurfacePixels(scene, frame, 1, 1).At(0, 0)->on_face, 2);
}

TEST(SurfaceFrame, SaysWhatIsNoFlatSurface) {
  EXPECT_EQ(DefectOf("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
            "none of its faces has an area");
  EXPECT_EQ(DefectOf("v 0 0 0\nv 1 0 0\nv 1 1 1e-300\nv 0 1 0\nf 1 2 3 4\n"),
            "face 1 (line 5) is not exactly planar");
  EXPECT_EQ(DefectOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"
                     "v 5 0 0\nv 6 0 0\nv 6 1 1e-300\nf 4 5 6\n"),
            "face 2 (line 8) is not exactly in the plane of face 1 (line 4)");
  EXPECT_NE(DefectOf("v 1 0 0\nv 2 0 0\nv 2 1 0\nv 0 0 0\nf 1 2 3 4\n")
                .find("the first corner of face 1 (line 5) lies on the line"),
            std::string::npos);
}

}  // namespace
}  // namespace truelux
