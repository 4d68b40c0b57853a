// SPDX-License-Identifier: GPL-3.0-or-later
// From a name or a camera to the receivers of a picture.

#include "image/picture_view.h"

#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

/// A floor of 4 x 2 at z = 0, two faces at z = 1 that look to different sides,
/// and a strip that is 1e12 times as high as wide.
Scene ThreeSurfaces() {
  return SceneFromText(
      "o floor\nv 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nf 1 2 3 4\n"
      "o twosided\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 5 6 7\nf 5 8 7\n"
      "o strip\nv 0 0 2\nv 1e-12 0 2\nv 1e-12 1 2\nv 0 1 2\nf 9 10 11 12\n");
}

/// What FrameOf and ReceiversOf throw; "" if they do not.
std::string ErrorOf(const PictureSubject& subject, const PictureSize& size) {
  const Scene scene = ThreeSurfaces();
  try {
    const PictureFrame frame = FrameOf(scene, subject);
    const auto receivers = ReceiversOf(scene, frame, size);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PictureView, RowsOfASurfaceFollowFromItsWidth) {
  const Scene scene = ThreeSurfaces();
  const PictureFrame frame = FrameOf(scene, "floor");
  EXPECT_TRUE(frame.notes.empty()) << TextOf(frame.notes);
  const auto receivers = ReceiversOf(scene, frame, {8, 0});
  EXPECT_EQ(receivers->width(), 8);
  EXPECT_EQ(receivers->height(), 4);
  EXPECT_EQ(receivers->At(0, 3)->position, (Point3{0.25, 0.25, 0}));
  EXPECT_EQ(ReceiversOf(scene, frame, {8, 5})->height(), 5);
  // Half a row is one, too.
  EXPECT_EQ(ReceiversOf(scene, FrameOf(scene, "floor"), {1, 0})->height(), 1);
}

TEST(PictureView, FacesThatLookToDifferentSidesAreNoted) {
  const Scene scene = ThreeSurfaces();
  EXPECT_EQ(TextOf(FrameOf(scene, "twosided").notes),
            "note: the faces of 'twosided' do not all look to one side (face 2 "
            "(line 12, twosided) and face 3 (line 13, twosided) differ): each "
            "point has the side of its own face\n");
}

TEST(PictureView, ACameraSeesTheFirstFace) {
  const Scene scene = ThreeSurfaces();
  const PictureFrame frame =
      FrameOf(scene, Camera{{3, 1, 5}, {3, 1, 0}, {0, 1, 0}, 20});
  EXPECT_TRUE(frame.notes.empty()) << TextOf(frame.notes);
  const auto receivers = ReceiversOf(scene, frame, {3, 3});
  EXPECT_EQ(receivers->At(1, 1)->on_face, 1);
  EXPECT_EQ(receivers->At(1, 1)->position, (Point3{3, 1, 0}));
}

TEST(PictureView, ASurfaceAtTheEndOfBinary64IsAnError) {
  const std::string most = "1.7e308";
  const Scene scene =
      SceneFromText("o a\nv -" + most + " -" + most + " 0\nv " + most + " -" +
                    most + " 0\nv " + most + " " + most + " 0\nv -" + most +
                    " " + most + " 0\nf 1 2 3 4\n");
  for (const PictureSize& size : {PictureSize{4, 4}, PictureSize{4, 0}}) {
    EXPECT_THROW((void)ReceiversOf(scene, FrameOf(scene, "a"), size),
                 std::invalid_argument);
  }
}

TEST(PictureView, SubjectsThatCannotBePicturedAreErrors) {
  EXPECT_EQ(ErrorOf(Camera{{3, 1, 5}, {3, 1, 5}, {0, 1, 0}, 20}, {8, 8}),
            "camera: the eye and the target are the same point");
  EXPECT_EQ(ErrorOf("floor", {8, 0}), "");
  EXPECT_EQ(ErrorOf("roof", {8, 0}),
            "surface: no object or group 'roof'; there are 'floor', "
            "'twosided', 'strip'");
  EXPECT_EQ(ErrorOf("strip", {8, 0}),
            "size: the surface is too long for square pixels; give "
            "WxH");
  EXPECT_EQ(ErrorOf("strip", {8, 8}), "");
}

TEST(PictureView, PicturesHaveAtMost2To26Pixels) {
  EXPECT_NO_THROW(CheckPixelCount(8192, 8192));
  EXPECT_THROW(CheckPixelCount(8192, 8193), std::invalid_argument);
  EXPECT_THROW(CheckPixelCount(65536, 65536), std::invalid_argument);  // 2^32
}

}  // namespace
}  // namespace truelux
